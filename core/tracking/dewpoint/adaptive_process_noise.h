// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/constant_velocity.h"
#include "core/filter/gaussian.h"

#include <Eigen/Core>

namespace dewpoint::tracking {

/// How a target has moved of late, and so how far it may be from where it is expected. The
/// acceleration that the user allows for (`acceleration_sigma`) is what a target may do; most of
/// the time it does much less, and a place predicted from what it did is far better.
class AdaptiveProcessNoise {
public:
  /// The motion of the next `allowed.interval` seconds: while the target is seen, with the
  /// acceleration that explains how well it was predicted; while it is not, with one that lasts, so
  /// that the error of the place grows with the square of the time. Never more than `allowed`.
  ConstantVelocity next(const ConstantVelocity& allowed);
  /// Another step without sight is made, or the target is seen again.
  void recordUnseen() { ++unseenSteps_; }
  void recordSeen();
  int unseenSteps() const { return unseenSteps_; }

  /// Learns from a look whose place was off by this many standard deviations, squared and summed
  /// over the three axes, and after which the velocity is this (m/s).
  void learn(double squaredDistance, const Eigen::Vector3d& velocity);

  /// To be added to the predicted covariance for gating: with it the prediction has the whole
  /// acceleration that the user allows, since the target was seen last.
  const Gaussian6::Matrix& gatingCovariance() const { return gatingCovariance_; }

private:
  double sigma_ = 0.0; ///< m/s² from frame to frame; 0: nothing known
  double most_ = 0.0;
  double interval_ = 0.0; ///< seconds, of the last step
  double lastingVariance_ = 0.0;
  double learned_ = 0.0; ///< looks that it was learned from
  Eigen::Vector3d slowVelocity_ = Eigen::Vector3d::Zero();
  int unseenSteps_ = 0;
  Gaussian6::Matrix gatingCovariance_ = Gaussian6::Matrix::Zero();
};

/// What a look says of the place alone: information (inverse covariance) and information vector,
/// relative to the predicted place.
struct InformationForm {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero(); ///< 1/m²
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();      ///< 1/m

  /// From what was known before (centered on the predicted place) and what is known after;
  /// `variance` (m²) along each axis is added to the look's own.
  static InformationForm between(const Gaussian3& before, const Gaussian3& after, double variance);
  /// The same relative to a place that lies `offset` from the predicted one.
  InformationForm relativeTo(const Eigen::Vector3d& offset) const {
    return {information, vector - information * offset};
  }
  /// The same with `factor` times the covariance.
  InformationForm inflated(double factor) const { return {information / factor, vector / factor}; }
  /// What is known after the look if nothing was before: the place as the look alone shows it, for
  /// the predicted one that the evidence is relative to.
  Gaussian3 asGaussian(const Eigen::Vector3d& predicted) const;
  /// What is known after the look, if `before` was known.
  Gaussian3 posterior(const Gaussian3& before) const;
  /// Squared Mahalanobis distance of the look from what was known before.
  double squaredDistance(const Eigen::Matrix3d& before) const;
};

} // namespace dewpoint::tracking
