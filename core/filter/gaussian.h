// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

#include <cmath>
#include <numbers>

namespace dewpoint::filter {

/// A normal distribution of fixed dimension.
template <int Dimension> struct Gaussian {
  using Vector = Eigen::Matrix<double, Dimension, 1>;
  using Matrix = Eigen::Matrix<double, Dimension, Dimension>;
  Vector mean = Vector::Zero();
  Matrix covariance = Matrix::Identity();
};
using Gaussian3 = Gaussian<3>;
/// Position and velocity: x y z vx vy vz.
using Gaussian6 = Gaussian<6>;

/// A normal distribution of a place, ready to be drawn from and evaluated many times.
class PreparedGaussian3 {
public:
  explicit PreparedGaussian3(const Gaussian3& gaussian)
      : mean_(gaussian.mean), factor_(gaussian.covariance.llt().matrixL()) {
    const double root = factor_.diagonal().prod();
    inverseFactor_ = factor_.triangularView<Eigen::Lower>().solve(Eigen::Matrix3d::Identity());
    logPeak_ = -std::log(root) - 1.5 * std::log(2.0 * std::numbers::pi);
  }

  /// The place that a standard normal vector stands for.
  Eigen::Vector3d place(const Eigen::Vector3d& standardNormal) const {
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

/// Replaces what a belief says about the place by a better informed one; the velocity follows as
/// far as it is correlated with the place (the update of a Kalman filter, written for a posterior
/// of the observed part).
inline void condition(Gaussian6& belief, const Gaussian3& place) {
  const Eigen::Matrix3d prior = belief.covariance.topLeftCorner<3, 3>();
  const Eigen::Matrix3d gain = belief.covariance.bottomLeftCorner<3, 3>() * prior.inverse();
  belief.mean.tail<3>() += gain * (place.mean - belief.mean.head<3>());
  belief.mean.head<3>() = place.mean;
  belief.covariance.bottomRightCorner<3, 3>() -=
      gain * (prior - place.covariance) * gain.transpose();
  belief.covariance.topLeftCorner<3, 3>() = place.covariance;
  belief.covariance.bottomLeftCorner<3, 3>() = gain * place.covariance;
  belief.covariance.topRightCorner<3, 3>() =
      belief.covariance.bottomLeftCorner<3, 3>().transpose().eval();
}

} // namespace dewpoint::filter
