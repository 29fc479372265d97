// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/gaussian.h"

#include <Eigen/Core>

namespace dewpoint::filter {

/// A normal distribution of a place, ready to be drawn from and evaluated many times.
class PreparedGaussian3 {
public:
  explicit PreparedGaussian3(const Gaussian3& gaussian);

  /// The place that a standard normal vector stands for.
  Eigen::Vector3d fromStandardNormal(const Eigen::Vector3d& standardNormal) const {
    return mean_ + factor_ * standardNormal;
  }
  /// Squared Mahalanobis distance.
  double squaredDistance(const Eigen::Vector3d& place) const {
    return (inverseFactor_ * (place - mean_)).squaredNorm();
  }
  double logDensity(const Eigen::Vector3d& place) const {
    return logPeak_ - 0.5 * squaredDistance(place);
  }

private:
  Eigen::Vector3d mean_;
  Eigen::Matrix3d factor_;
  Eigen::Matrix3d inverseFactor_;
  double logPeak_ = 0.0;
};

} // namespace dewpoint::filter
