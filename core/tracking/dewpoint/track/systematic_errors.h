// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::tracking {

/// Errors that are the same in all frames and therefore do not average out.
struct SystematicErrors {
  /// Standard deviation in radians, along each axis, of the direction in which a camera sees a
  /// point: the error of its calibration.
  double directionSigma = 0.0;
  /// Standard deviation of the time of an image, in seconds.
  double timeSigma = 0.0;
};

/// Returns the covariance (m²) of a position that results from errors of the directions in which
/// cameras see the position. `sigma` (radians) is the standard deviation of the directions, and
/// `cameraCenters` are the optical centers of the cameras (meters, world frame). Returns zero
/// without cameras.
Eigen::Matrix3d covarianceFromDirectionErrors(const Eigen::Vector3d& position,
                                              const std::vector<Eigen::Vector3d>& cameraCenters,
                                              double sigma);

/// Returns the covariance (m²) of a position: `known` plus the `systematic` errors of the images.
/// If the user has also given a position, its covariance is `given`, and `known` includes this
/// information. The errors of the images then widen only the part of `known` that comes from the
/// images.
Eigen::Matrix3d withSystematicErrors(const Eigen::Matrix3d& known,
                                     const Eigen::Matrix3d& systematic,
                                     const std::optional<Eigen::Matrix3d>& given);

/// Returns the probability that a target is within `radius` (meters) of an estimate with this
/// covariance (m²).
double probabilityWithin(const Eigen::Matrix3d& covariance, double radius);

} // namespace dewpoint::tracking
