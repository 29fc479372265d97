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

ExtentErrors extentErrors(std::span<const ExtentSample> samples) {
  ExtentErrors result;
  std::vector<double> centroids;
  std::vector<double> sizes;
  for (const ExtentSample& sample : samples) {
    ++result.nearProportion.total;
    if (sample.distance && sample.halfExtent > 0.0 && std::isfinite(*sample.distance)) {
      centroids.push_back(*sample.distance / sample.halfExtent);
      result.nearProportion.count += centroids.back() <= kNearFraction ? 1 : 0;
    }
    if (sample.estimatedRadius && sample.radius > 0.0 && std::isfinite(*sample.estimatedRadius)) {
      sizes.push_back(std::abs(*sample.estimatedRadius - sample.radius) / sample.radius);
    }
  }
  result.centroid = medianIfAny(std::move(centroids));
  result.size = medianIfAny(std::move(sizes));
  return result;
}

} // namespace dewpoint::experiment
