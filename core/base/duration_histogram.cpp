// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/duration_histogram.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::base {
namespace {

constexpr double kShortest = 1e-9; // seconds
constexpr double kGrowth = 1.01;

} // namespace

void DurationHistogram::add(double seconds) {
  if (!(seconds >= 0.0)) {
    return;
  }
  const double bucket = std::log(std::max(seconds, kShortest) / kShortest) / std::log(kGrowth);
  ++buckets_[static_cast<std::size_t>(std::min(bucket, kBuckets - 1.0))];
  ++count_;
  longest_ = std::max(longest_, seconds);
}

double DurationHistogram::quantile(double share) const {
  const double wanted = std::clamp(share, 0.0, 1.0) * static_cast<double>(count_);
  double below = 0.0;
  for (int k = 0; k < kBuckets && count_ > 0; ++k) {
    below += buckets_[static_cast<std::size_t>(k)];
    if (below > 0.0 && below >= wanted) {
      return share >= 1.0 ? longest_ : std::min(longest_, kShortest * std::pow(kGrowth, k + 0.5));
    }
  }
  return longest_;
}

} // namespace dewpoint::base
