// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/adaptive_size.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace dewpoint::filter {

Eigen::Index kldSampleSize(std::int64_t occupiedBins, double error) {
  if (occupiedBins < 2 || !(error > 0.0)) {
    return 1;
  }
  /// Quantile of the standard normal distribution for a confidence of 99 %.
  constexpr double kUpperQuantile = 2.3263478740;
  const auto degrees = static_cast<double>(occupiedBins - 1);
  const double ratio = 2.0 / (9.0 * degrees);
  const double root = 1.0 - ratio + std::sqrt(ratio) * kUpperQuantile;
  return static_cast<Eigen::Index>(std::ceil(degrees / (2.0 * error) * root * root * root));
}

std::int64_t countOccupiedBins(const Eigen::ArrayXXd& states, double binSize) {
  std::vector<std::array<std::int64_t, 3>> bins(static_cast<std::size_t>(states.rows()));
  for (std::size_t i = 0; i < bins.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double bin =
          states(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(axis)) / binSize;
      bins[i][axis] = static_cast<std::int64_t>(std::floor(std::clamp(bin, -1e15, 1e15)));
    }
  }
  std::sort(bins.begin(), bins.end());
  return std::unique(bins.begin(), bins.end()) - bins.begin();
}

} // namespace dewpoint::filter
