// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace dewpoint::filter {

/// Cumulative sums are taken in order within stretches of kStretch elements, and each stretch is
/// then moved by the sum of those before: threads and processors of any number give the same bits.
inline constexpr std::int64_t kStretch = 256;
/// Stretches that are summed up side by side: an addition has to wait for the one before it, but
/// not for those of other stretches.
inline constexpr std::int64_t kAbreast = 4;
inline constexpr std::int64_t kPrefixBlock = kStretch * kAbreast;

using StretchSums = std::array<double, kAbreast>;

/// Sums up the stretches of a block of `count` <= kPrefixBlock values, each by itself, and hands
/// every sum on the way to put(index, sum). Returns the sums of the stretches, zero for empty ones.
template <class Value, class Put>
[[gnu::always_inline]] inline StretchSums prefixSums(const Value* values, std::int64_t count,
                                                     const Put& put) {
  StretchSums sums{};
  double* sum = sums.data();
  const auto abreast = [&](std::int64_t stretches, std::int64_t begin, std::int64_t end)
      __attribute__((always_inline)) {
    for (std::int64_t i = begin; i < end; ++i) {
      for (std::int64_t k = 0; k < stretches; ++k) {
        sum[k] += double{values[k * kStretch + i]};
        put(k * kStretch + i, sum[k]);
      }
    }
  };
  const std::int64_t whole = count / kStretch;
  const std::int64_t rest = count % kStretch;
  if (whole == kAbreast) {
    abreast(kAbreast, 0, kStretch);
  } else if (whole == kAbreast - 1) {
    abreast(kAbreast, 0, rest);
    abreast(kAbreast - 1, rest, kStretch);
  } else {
    abreast(whole, 0, kStretch);
    for (std::int64_t i = 0; i < rest; ++i) {
      sum[whole] += double{values[whole * kStretch + i]};
      put(whole * kStretch + i, sum[whole]);
    }
  }
  return sums;
}

} // namespace dewpoint::filter
