// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <array>
#include <cstdint>

namespace dewpoint::base {

/// Histogram that holds any number of durations in a fixed amount of memory. Each bucket is one
/// percent wider than the previous bucket, so quantiles are accurate to half a percent. The buckets
/// cover 1 ns to 20 minutes. Longer and shorter durations are counted in the last and first bucket.
/// The longest duration is stored exactly.
class DurationHistogram {
public:
  /// Adds a duration in seconds. Negative durations and NaN are not counted.
  void add(double seconds);
  std::int64_t count() const { return count_; }
  /// Returns the quantile `share` (0 to 1) of the durations, in seconds: the duration that this
  /// fraction of all durations does not exceed. Returns 0 if the histogram is empty.
  double quantile(double share) const;
  /// Returns the longest duration in seconds, or 0 if the histogram is empty.
  double longest() const { return longest_; }

private:
  static constexpr int kBuckets = 2800;

  std::array<std::uint32_t, kBuckets> buckets_{};
  std::int64_t count_ = 0;
  double longest_ = 0.0;
};

} // namespace dewpoint::base
