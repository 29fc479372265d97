// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::base {

/// Vector instructions that a kernel may use. A kernel is a loop that is compiled once for each
/// instruction set (vector_kernel.h). Baseline: the instructions that every processor of the
/// architecture supports. Avx2 (256 bits wide) and Avx512 (512 bits wide) exist only on x86-64.
enum class InstructionSet { Baseline, Avx2, Avx512 };

/// Returns the widest instruction set that this processor supports, or the limit that an
/// InstructionSetLimit sets, whichever is lower.
InstructionSet instructionSet();

/// Prevents all kernels (loops run by runKernel()) from using wider instructions than `limit` while
/// this object exists. Tests and benchmarks use this class to compare the compiled versions of a
/// kernel.
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
