// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <cstdint>

namespace dewpoint::filter {

/// Weighted mean and scatter of a group of particles. The values of several groups are combined
/// with the formulas of Chan, Golub and LeVeque (1983). These formulas keep the digits that a sum
/// of squares about a distant origin would lose.
struct Moments {
  double weightSum = 0.0;        ///< sum of the weights
  double squaredWeightSum = 0.0; ///< sum of the squared weights
  double largestWeight = -1.0;   ///< largest weight
  Eigen::Index largestIndex = 0; ///< index of the particle with the largest weight
  Eigen::VectorXd mean;          ///< weighted mean; empty if all weights are zero
  Eigen::MatrixXd scatter;       ///< sum of weight * deviation * deviation', lower triangle only

  /// Adds the statistics of other particles, whose weights are first multiplied by `factor`.
  void add(const Moments& other, double factor = 1.0);
};

/// Returns the mean and scatter of particles `begin` to `end` - 1, whose weights are weights[0],
/// weights[1], ...
Moments measureMoments(const Eigen::ArrayXXd& states, const double* weights, std::int64_t begin,
                       std::int64_t end);

} // namespace dewpoint::filter
