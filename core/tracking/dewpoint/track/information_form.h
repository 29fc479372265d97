// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/gaussian.h"

#include <Eigen/Core>

namespace dewpoint::tracking {

/// Measured position in information form: information (inverse covariance) and information vector,
/// relative to the predicted position.
struct InformationForm {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero(); ///< inverse covariance, 1/m²
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();      ///< information vector, 1/m

  /// Returns the measurement that updates the Gaussian `before` (centered on the predicted
  /// position) to `after`. Then `variance` (m²) is added to the covariance of this measurement,
  /// along each axis.
  static InformationForm measurementBetween(const Gaussian3& before, const Gaussian3& after,
                                            double variance);
  /// Returns the same measurement relative to the predicted position plus `offset` (m).
  InformationForm relativeTo(const Eigen::Vector3d& offset) const {
    return {information, vector - information * offset};
  }
  /// Returns the same measurement with its covariance multiplied by `factor`.
  InformationForm inflated(double factor) const { return {information / factor, vector / factor}; }
  /// Returns the measured position alone (m, m²); `predicted` is the position to which the
  /// measurement is relative.
  Gaussian3 asGaussian(const Eigen::Vector3d& predicted) const;
  /// Returns the posterior distribution of the position after this measurement updates the prior
  /// `before`.
  Gaussian3 posterior(const Gaussian3& before) const;
  /// Returns the squared Mahalanobis distance of the measurement from a prior with this covariance
  /// (m²), centered on the predicted position.
  double squaredMahalanobisDistance(const Eigen::Matrix3d& before) const;
};

} // namespace dewpoint::tracking
