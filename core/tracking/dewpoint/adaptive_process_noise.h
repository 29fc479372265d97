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

/// A measured position in information form: information (inverse covariance) and information
/// vector, relative to the predicted position.
struct InformationForm {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero(); ///< 1/m²
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();      ///< 1/m

  /// The measurement that turns the Gaussian `before` (centered on the predicted position) into
  /// `after`, with `variance` (m²) along each axis added to its covariance.
  static InformationForm between(const Gaussian3& before, const Gaussian3& after, double variance);
  /// The same measurement relative to a position that lies `offset` (m) from the predicted one.
  InformationForm relativeTo(const Eigen::Vector3d& offset) const {
    return {information, vector - information * offset};
  }
  /// The same measurement with `factor` times its covariance.
  InformationForm inflated(double factor) const { return {information / factor, vector / factor}; }
  /// The measured position (m, m²) alone; `predicted` is the position that it is relative to.
  Gaussian3 asGaussian(const Eigen::Vector3d& predicted) const;
  /// The posterior of the prior `before`.
  Gaussian3 posterior(const Gaussian3& before) const;
  /// Squared Mahalanobis distance of the measurement from a prior of this covariance (m²), centered
  /// on the predicted position.
  double squaredDistance(const Eigen::Matrix3d& before) const;
};

} // namespace dewpoint::tracking
