// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <array>
#include <cstdint>

namespace dewpoint::base {

/// Histogram of any number of durations in fixed memory. Quantiles are off by at most half a
/// percent. Buckets grow by one percent from 1 ns to 20 minutes; durations outside that range fall
/// into the first or the last bucket. The longest duration is exact.
class DurationHistogram {
public:
  /// Adds a duration in seconds. Negative durations and NaN are not counted.
  void add(double seconds);
  std::int64_t count() const { return count_; }
  /// Duration in seconds that the given share (0 to 1) of all durations does not exceed; 0 when
  /// there are none.
  double quantile(double share) const;
  double longest() const { return longest_; }

private:
  static constexpr int kBuckets = 2800;

  std::array<std::uint32_t, kBuckets> buckets_{};
  std::int64_t count_ = 0;
  double longest_ = 0.0;
};

} // namespace dewpoint::base
