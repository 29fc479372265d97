// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/extent_errors.h"

#include "core/base/statistics.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace dewpoint::experiment {
namespace {

double medianIfAny(std::vector<double> values) {
  return values.empty() ? std::numeric_limits<double>::quiet_NaN() : median(std::move(values));
}

} // namespace

ExtentErrors measureExtentErrors(std::span<const ExtentSample> samples) {
  ExtentErrors result;
  std::vector<double> centroids;
  std::vector<double> sizes;
  for (const ExtentSample& sample : samples) {
    ++result.nearEstimateProportion.total;
    if (sample.centroidDistance && sample.halfExtent > 0.0 &&
        std::isfinite(*sample.centroidDistance)) {
      centroids.push_back(*sample.centroidDistance / sample.halfExtent);
      result.nearEstimateProportion.count += centroids.back() <= kNearFraction ? 1 : 0;
    }
    if (sample.estimatedRadius && sample.radius > 0.0 && std::isfinite(*sample.estimatedRadius)) {
      sizes.push_back(std::abs(*sample.estimatedRadius - sample.radius) / sample.radius);
    }
  }
  result.relativeCentroidError = medianIfAny(std::move(centroids));
  result.relativeSizeError = medianIfAny(std::move(sizes));
  return result;
}

} // namespace dewpoint::experiment
