// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::tracking {

/// What is wrong in all frames alike, so that no number of frames averages it away.
struct SystematicErrors {
  /// Radians, standard deviation of the direction in which a camera sees a point, along each axis:
  /// what its calibration is off by.
  double direction = 0.0;
  /// Seconds, standard deviation of the time of an image.
  double time = 0.0;
};

/// Covariance (m²) of a position from directions that are off by `sigma` (radians) in the cameras
/// that see it, whose optical centers these are (meters, world); zero when there are none.
Eigen::Matrix3d covarianceOfDirections(const Eigen::Vector3d& position,
                                       const std::vector<Eigen::Vector3d>& cameraCenters,
                                       double sigma);

/// The covariance (m²) of a position whose covariance by images and by what was `given` is `known`,
/// when `systematic` errors of the images add to it. They do not touch what was given by hand.
Eigen::Matrix3d withSystematicErrors(const Eigen::Matrix3d& known,
                                     const Eigen::Matrix3d& systematic,
                                     const std::optional<Eigen::Matrix3d>& given);

/// Probability that a target is within `radius` (meters) of an estimate of this covariance (m²).
double probabilityWithin(const Eigen::Matrix3d& covariance, double radius);

} // namespace dewpoint::tracking
