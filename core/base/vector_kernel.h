// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/instruction_set.h"

/// Declares the function `run` of a kernel, which contains the loop that runKernel() executes. The
/// function must be inlined, because it is compiled once for each instruction set.
#define DEWPOINT_KERNEL [[gnu::always_inline]] static inline

#if defined(__x86_64__)
#if defined(__clang__)
#define DEWPOINT_AVX512 "avx512f,avx512bw,avx512dq,avx512vl,avx512vbmi"
#else
#define DEWPOINT_AVX512 "avx512f,avx512bw,avx512dq,avx512vl,avx512vbmi,prefer-vector-width=512"
#endif
#endif

namespace dewpoint::base {

#if defined(__x86_64__)
template <class Kernel, class... Arguments>
[[gnu::target("avx2"), gnu::noinline]] void runKernelAvx2(Arguments... arguments) {
  Kernel::run(arguments...);
}

template <class Kernel, class... Arguments>
[[gnu::target(DEWPOINT_AVX512), gnu::noinline]] void runKernelAvx512(Arguments... arguments) {
  Kernel::run(arguments...);
}
#endif

/// Runs `Kernel::run(arguments...)`, which is a plain loop without intrinsics. The loop is compiled
/// once for each instruction set, and the version for this processor is chosen at run time. All
/// versions give bit-identical floating-point results for two reasons. The compiler may neither
/// reorder sums nor contract products (-ffp-contract=off). Kernels use only operations whose
/// rounding IEEE 754 defines: the basic operations and the square root.
template <class Kernel, class... Arguments> void runKernel(Arguments... arguments) {
#if defined(__x86_64__)
  switch (instructionSet()) {
  case InstructionSet::Avx512:
    return runKernelAvx512<Kernel>(arguments...);
  case InstructionSet::Avx2:
    return runKernelAvx2<Kernel>(arguments...);
  case InstructionSet::Baseline:
    break;
  }
#endif
  Kernel::run(arguments...);
}

} // namespace dewpoint::base
