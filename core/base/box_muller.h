// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/elementary.h"

#include <cmath>
#include <cstdint>

namespace dewpoint {

struct NormalPair {
  double first;
  double second;
};

/// Two independent standard normal numbers from two random words (Box & Muller 1958).
[[gnu::always_inline]] inline NormalPair boxMuller(std::uint32_t radiusWord,
                                                   std::uint32_t angleWord) {
  // Half a step away from 0, where the logarithm is not finite.
  const double radius = std::sqrt(-2.0 * logarithm((radiusWord + 0.5) * 0x1.0p-32));
  const auto [cosine, sine] = cosineSine(angleWord);
  return {radius * cosine, radius * sine};
}

} // namespace dewpoint
