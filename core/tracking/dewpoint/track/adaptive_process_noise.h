// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/constant_velocity.h"
#include "core/filter/gaussian.h"

#include <Eigen/Core>

namespace dewpoint::tracking {

/// The process noise of one target, learned from how well its recent motion was predicted
/// (covariance matching: Mehra 1972). The acceleration that the user allows (`acceleration_sigma`)
/// is the most that a target does; mostly it does much less, and a prediction with less noise is
/// far better.
class AdaptiveProcessNoise {
public:
  /// The motion model of the next `allowed.interval` seconds. While the target is seen, its
  /// acceleration is the one that explains the recent prediction errors; while it is not seen, an
  /// acceleration that lasts, so that the error of the position grows with the square of the time.
  /// Never more than that of `allowed`.
  ConstantVelocity next(const ConstantVelocity& allowed);
  /// The target was not seen in the last step, or it was.
  void recordUnseen() { ++unseenSteps_; }
  void recordSeen();
  int unseenSteps() const { return unseenSteps_; }

  /// Learns from a measured position at this squared Mahalanobis distance (three degrees of
  /// freedom) from the prediction. `velocity` (m/s) is the one after the update.
  void learn(double squaredDistance, const Eigen::Vector3d& velocity);

  /// The covariance to add to that of the prediction for gating: with it the target may have had
  /// the whole allowed acceleration since it was last seen.
  const Gaussian6::Matrix& gatingCovariance() const { return gatingCovariance_; }

private:
  double sigma_ = 0.0;           ///< m/s² from frame to frame; 0: not known
  double most_ = 0.0;            ///< m/s², allowed in the last step
  double interval_ = 0.0;        ///< seconds, of the last step
  double lastingVariance_ = 0.0; ///< (m/s²)²
  double learned_ = 0.0;         ///< updates that it was learned from
  Eigen::Vector3d slowVelocity_ = Eigen::Vector3d::Zero(); ///< m/s, running mean
  int unseenSteps_ = 0;
  Gaussian6::Matrix gatingCovariance_ = Gaussian6::Matrix::Zero();
};

} // namespace dewpoint::tracking
