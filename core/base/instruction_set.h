// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::base {

/// Width of the vector instructions that a kernel may use. Every processor has the baseline of its
/// architecture; the other two are 256 and 512 bits wide on x86-64.
enum class InstructionSet { Baseline, Avx2, Avx512 };

/// Widest instruction set of this processor, or the limit that a test or a benchmark has set if
/// that is lower.
InstructionSet instructionSet();

/// Limits kernels to an instruction set during its lifetime. Tests and benchmarks use it to compare
/// the versions of a kernel.
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
