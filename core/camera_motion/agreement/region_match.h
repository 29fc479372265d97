// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

namespace dewpoint::camera_motion {

/// Region in a target's color in one image, like ColorRegion, but with directions and angles in
/// place of pixels. `radius`, `sigma` and `biasSigma` are angles in radians.
struct SeenRegion {
  Eigen::Vector3d direction;     ///< direction to the center: unit vector, camera axes
  Eigen::Vector3d directionRate; ///< change of `direction` per second
  double radius;
  double sigma;     ///< standard deviation of the center, per axis
  double biasSigma; ///< part of `sigma` that is constant while the object moves
  /// True if the region moved enough to count (RegionSighting::countsAsEvidence).
  bool countsAsEvidence;
};

/// Result of matchRegions(): how well two regions, each in the image of another camera, match as
/// views of the same object.
struct RegionMatch {
  double relativeLikelihood = 0.0; ///< likelihood divided by the likelihood of unrelated regions
  double residual = 0.0;           ///< distance between the two rays, in standard deviations
  /// Derivative of `residual` with respect to the direction `u` to the region in the first camera.
  Eigen::Vector3d residualByU = Eigen::Vector3d::Zero();
  /// Derivative of `residual` with respect to the direction `v` to the region in the second camera.
  Eigen::Vector3d residualByV = Eigen::Vector3d::Zero();
  /// Radius of the object seen by both cameras, in the unit of the camera positions; 0: unknown.
  double objectRadius = 0.0;
};

/// Returns how well region `a` in a first camera matches region `b` in a second camera. `a` is seen
/// along the unit vector `u`, and `b` along the unit vector `v`. `apart` is the vector from the
/// first to the second camera; it must not be zero. `u`, `v` and `apart` are in world axes. `field`
/// (radians) is the angular height of the second camera's image. `widening` (radians) is an
/// additional uncertainty of both directions.
RegionMatch matchRegions(const SeenRegion& a, const Eigen::Vector3d& u, const SeenRegion& b,
                         const Eigen::Vector3d& v, const Eigen::Vector3d& apart, double widening,
                         double field);

} // namespace dewpoint::camera_motion
