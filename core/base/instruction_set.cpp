// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/instruction_set.h"

#include <algorithm>
#include <atomic>

namespace dewpoint::base {
namespace {

InstructionSet widest() {
#if defined(__x86_64__)
  const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
                      __builtin_cpu_supports("avx512vbmi");
  if (avx512) {
    return InstructionSet::Avx512;
  }
  if (__builtin_cpu_supports("avx2")) {
    return InstructionSet::Avx2;
  }
#endif
  return InstructionSet::Baseline;
}

std::atomic<InstructionSet> limit{InstructionSet::Avx512};

} // namespace

InstructionSet instructionSet() {
  static const InstructionSet best = widest();
  return std::min(best, limit.load(std::memory_order_relaxed));
}

InstructionSetLimit::InstructionSetLimit(InstructionSet most) : before_(limit.exchange(most)) {}

InstructionSetLimit::~InstructionSetLimit() {
  limit = before_;
}

} // namespace dewpoint::base
