// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/filter/gaussian.h"

#include <Eigen/Core>

namespace dewpoint::filter {

/// Normal distribution of a position (meters), prepared for many draws and evaluations: the matrix
/// factors are computed only once.
class PreparedGaussian3 {
public:
  explicit PreparedGaussian3(const Gaussian3& gaussian);

  /// Transforms a standard normal vector to a sample of this distribution.
  Eigen::Vector3d fromStandardNormal(const Eigen::Vector3d& standardNormal) const {
    return mean_ + factor_ * standardNormal;
  }
  /// Draws `count` samples, one per row: x y z. Sample i uses element i of the stream.
  Eigen::ArrayXXd draw(Eigen::Index count, const RandomStream& stream) const;
  /// Returns the squared Mahalanobis distance of a position from the mean.
  double squaredDistance(const Eigen::Vector3d& position) const {
    return (inverseFactor_ * (position - mean_)).squaredNorm();
  }
  /// Returns the natural logarithm of the density at a position.
  double logDensity(const Eigen::Vector3d& position) const {
    return logPeak_ - 0.5 * squaredDistance(position);
  }

private:
  Eigen::Vector3d mean_;
  Eigen::Matrix3d factor_;
  Eigen::Matrix3d inverseFactor_;
  double logPeak_ = 0.0;
};

} // namespace dewpoint::filter
