// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <cstdint>

namespace dewpoint::filter {

/// Weighted moments of some particles. Blocks are put together by the formulas of Chan, Golub and
/// LeVeque (1983), which keep the digits that a sum of squares about a far origin would lose.
struct Moments {
  double weight = 0.0;
  double squares = 0.0; ///< of the weights
  double largest = -1.0;
  Eigen::Index largestIndex = 0;
  Eigen::VectorXd mean;    ///< empty where all weights are zero
  Eigen::MatrixXd scatter; ///< sum of weight * deviation * deviation', lower triangle

  /// Adds the moments of further particles, whose weights are multiplied by `factor` first.
  void add(const Moments& other, double factor = 1.0);
};

/// The moments of particles begin to end - 1, whose weights are weights[0], weights[1], ...
Moments measureMoments(const Eigen::ArrayXXd& states, const double* weights, std::int64_t begin,
                       std::int64_t end);

} // namespace dewpoint::filter
