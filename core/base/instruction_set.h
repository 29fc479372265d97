// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::base {

/// Width of the vector instructions that a kernel may use. Every processor supports the baseline of
/// its architecture. On x86-64, the other two are 256 and 512 bits wide.
enum class InstructionSet { Baseline, Avx2, Avx512 };

/// Returns the widest instruction set of this processor, or a lower limit set by a test or
/// benchmark.
InstructionSet instructionSet();

/// Limits kernels to an instruction set for the lifetime of this object. Tests and benchmarks use
/// it to compare the compiled versions of a kernel.
class InstructionSetLimit {
public:
  explicit InstructionSetLimit(InstructionSet limit);
  ~InstructionSetLimit();
  InstructionSetLimit(const InstructionSetLimit&) = delete;
  InstructionSetLimit& operator=(const InstructionSetLimit&) = delete;

private:
  InstructionSet before_;
};

} // namespace dewpoint::base
