// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/constant_velocity.h"
#include "core/filter/gaussian.h"

#include <Eigen/Core>

namespace dewpoint::tracking {

/// Process noise of one target, learned from how well its recent motion was predicted (covariance
/// matching: Mehra 1972). The acceleration that the user allows (`acceleration_sigma`) is an upper
/// limit. A target usually accelerates much less, and less process noise then gives a much better
/// prediction.
class AdaptiveProcessNoise {
public:
  /// Returns the motion model for the next `allowed.interval` seconds. While the target is visible,
  /// the model's acceleration is large enough to explain the recent prediction errors. While the
  /// target is not visible, its acceleration is assumed to persist, so that the position error
  /// grows with the square of the time. The acceleration never exceeds the acceleration of
  /// `allowed`.
  ConstantVelocity nextMotion(const ConstantVelocity& allowed);
  /// Records that the target was not visible in the last step.
  void recordUnseen() { ++unseenSteps_; }
  /// Records that the target was visible in the last step.
  void recordSeen();
  int unseenStepCount() const { return unseenSteps_; }

  /// Learns from a measured position. `squaredDistance` is the squared Mahalanobis distance (three
  /// degrees of freedom) of this position from the prediction. `velocity` is the velocity of the
  /// target after the update, m/s.
  void learn(double squaredDistance, const Eigen::Vector3d& velocity);

  /// Returns the covariance to add to the prediction when deciding which measurements can belong to
  /// the target. The covariance allows for the full acceleration limit since the target was last
  /// visible.
  const Gaussian6::Matrix& gatingCovariance() const { return gatingCovariance_; }

private:
  double sigma_ = 0.0;           ///< learned frame-to-frame acceleration, m/s²; 0: unknown
  double most_ = 0.0;            ///< limit in the last step, m/s²
  double interval_ = 0.0;        ///< duration of the last step, seconds
  double lastingVariance_ = 0.0; ///< variance of a persistent acceleration, (m/s²)²
  double learned_ = 0.0;         ///< number of updates learned from
  Eigen::Vector3d slowVelocity_ = Eigen::Vector3d::Zero(); ///< m/s, running mean
  int unseenSteps_ = 0;
  Gaussian6::Matrix gatingCovariance_ = Gaussian6::Matrix::Zero();
};

} // namespace dewpoint::tracking
