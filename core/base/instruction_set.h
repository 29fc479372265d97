// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::base {

/// How wide the vector instructions are that a kernel may use. Every processor has the baseline of
/// its architecture; the other two are 256 and 512 bit wide on x86-64.
enum class InstructionSet { Baseline, Avx2, Avx512 };

/// The widest set of this processor, or the limit set by a test or a benchmark if that is lower.
InstructionSet instructionSet();

/// Keeps kernels below a width while it lives: tests and benchmarks compare the paths with it.
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
