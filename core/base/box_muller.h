// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/elementary.h"
#include "core/base/elementary_single.h"

#include <cmath>
#include <cstdint>

namespace dewpoint::base {

/// Pair of independent standard normal numbers, in double precision.
struct NormalPair {
  double first;
  double second;
};

/// Computes two independent standard normal numbers from two uniform random words (Box & Muller
/// 1958).
[[gnu::always_inline]] inline NormalPair boxMuller(std::uint32_t radiusWord,
                                                   std::uint32_t angleWord) {
  // Half a step away from 0, where the logarithm is infinite.
  const double radius = std::sqrt(-2.0 * logarithm((radiusWord + 0.5) * 0x1.0p-32));
  const auto [cosine, sine] = cosineSine(angleWord);
  return {radius * cosine, radius * sine};
}

/// Pair of independent standard normal numbers, in single precision.
struct NormalPairSingle {
  float first;
  float second;
};

/// Computes two independent standard normal numbers from two uniform random words, like
/// boxMuller(), but in single precision.
[[gnu::always_inline]] inline NormalPairSingle boxMullerSingle(std::uint32_t radiusWord,
                                                               std::uint32_t angleWord) {
  const float radius = std::sqrt(-2.0F * logarithm(toUnitInterval(radiusWord)));
  const auto [cosine, sine] = cosineSineSingle(angleWord);
  return {radius * cosine, radius * sine};
}

/// Returns an exponentially distributed number with mean 1, computed from a uniform random word by
/// inverting the distribution function.
[[gnu::always_inline]] inline float exponentialVariate(std::uint32_t word) {
  return 0.0F - logarithm(toUnitInterval(word)); // never minus zero
}

} // namespace dewpoint::base
