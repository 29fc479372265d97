// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <array>
#include <cstdint>

namespace dewpoint::base {

/// Histogram that holds any number of durations in a fixed amount of memory. Quantiles are accurate
/// to half a percent. Buckets grow by one percent from 1 ns to 20 minutes. Durations outside that
/// range fall into the first or last bucket. The longest duration is exact.
class DurationHistogram {
public:
  /// Adds a duration in seconds. Negative durations and NaN are not counted.
  void add(double seconds);
  std::int64_t count() const { return count_; }
  /// Returns the duration in seconds that the given fraction (0 to 1) of all durations does not
  /// exceed. Returns 0 if the histogram is empty.
  double quantile(double share) const;
  double longest() const { return longest_; }

private:
  static constexpr int kBuckets = 2800;

  std::array<std::uint32_t, kBuckets> buckets_{};
  std::int64_t count_ = 0;
  double longest_ = 0.0;
};

} // namespace dewpoint::base
