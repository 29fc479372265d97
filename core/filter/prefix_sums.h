// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace dewpoint::filter {

/// Number of elements in a stretch. A stretch is a run of consecutive elements, with fixed borders.
/// Cumulative sums are taken in order within a stretch, and the sum of all earlier stretches is
/// added afterwards. The results are therefore bit-identical for any number of threads and on any
/// processor.
inline constexpr std::int64_t kStretch = 256;
/// Number of stretches that are summed at the same time. Each addition has to wait for the previous
/// addition in its stretch, but not for additions in other stretches.
inline constexpr std::int64_t kLanes = 4;
/// Number of elements in a block of stretches.
inline constexpr std::int64_t kPrefixBlock = kStretch * kLanes;

/// Sums of the stretches of a block, one per stretch.
using StretchSums = std::array<double, kLanes>;

/// Computes the running sums within each stretch of a block of `count` <= kPrefixBlock values, and
/// calls put(index, sum) for each running sum. Returns the total of each stretch, which is zero for
/// an empty stretch.
template <class Value, class Put>
[[gnu::always_inline]] inline StretchSums prefixSums(const Value* values, std::int64_t count,
                                                     const Put& put) {
  StretchSums sums{};
  double* sum = sums.data();
  const auto addElements = [&](std::int64_t stretches, std::int64_t begin, std::int64_t end)
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
  if (whole == kLanes) {
    addElements(kLanes, 0, kStretch);
  } else if (whole == kLanes - 1) {
    addElements(kLanes, 0, rest);
    addElements(kLanes - 1, rest, kStretch);
  } else {
    addElements(whole, 0, kStretch);
    for (std::int64_t i = 0; i < rest; ++i) {
      sum[whole] += double{values[whole * kStretch + i]};
      put(whole * kStretch + i, sum[whole]);
    }
  }
  return sums;
}

} // namespace dewpoint::filter
