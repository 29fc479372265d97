// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/gaussian.h"

#include <Eigen/Core>

namespace dewpoint::tracking {

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
