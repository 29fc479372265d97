// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/geometry/camera.h"

#include <Eigen/Core>

#include <span>

namespace dewpoint::calibration {

/// Point whose position is known from the other cameras, and the pixel at which the moved camera
/// sees it.
struct PointSighting {
  Eigen::Vector3d world = Eigen::Vector3d::Zero(); ///< position, meters
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  /// Standard deviation of the difference between `pixel` and the projection of `world`, per axis;
  /// pixels.
  double sigmaPixels = 1.0;
};

/// Knowledge about a camera motion before the sightings are used.
struct CameraMotionPrior {
  /// Rotation of the camera measured from the background, as a rotation vector
  /// (CameraRotation::turn); radians.
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
  /// Standard deviation of `turn`, radians.
  double rotationSigma = 2e-4;
  double shiftSigma = 0.01; ///< standard deviation of a possible displacement of the camera; meters
};

/// New pose of a camera that was moved.
struct MovedCameraPose {
  Camera camera;
  /// Number of sightings that agree with the new pose within three sigma.
  int usedSightingCount = 0;
  /// Median distance between the pixels of all sightings and their projections with the old pose,
  /// in pixels; 0 if there are no sightings.
  double medianResidualPxBefore = 0.0;
  /// Median distance between the pixels of all sightings and their projections with the new pose,
  /// pixels.
  double medianResidualPxAfter = 0.0;
  /// Standard deviation of the rotation, radians, camera axes.
  Eigen::Vector3d angleSigma = Eigen::Vector3d::Zero();
  /// Standard deviation of the position, meters, camera axes.
  Eigen::Vector3d shiftSigma = Eigen::Vector3d::Zero();
};

/// Returns the camera rotated about its center by the rotation vector `turn` (radians, camera
/// axes). The rotation is exact. To first order, the new cameraFromWorld is (I + [turn]x) times the
/// old one.
Camera rotatedCamera(const Camera& camera, const Eigen::Vector3d& turn);

/// Estimates the new pose of one camera that was moved. Its intrinsics and all other cameras stay
/// fixed. Method: least squares (Ceres) over the six pose parameters. The residuals are those of
/// the sightings (with a Huber loss at two sigma) and of the prior.
///
/// In the images of the background, a displacement of the camera looks like a rotation. Its angle
/// is the displacement divided by the distance of the background, which is assumed to be 3 m. The
/// standard deviation of the prior's rotation is therefore hypot(rotationSigma, shiftSigma / 3 m).
/// Without sightings, the result is the old pose, rotated by `prior.turn`. Error: Mismatch if fewer
/// than half of the sightings agree with the result.
Result<MovedCameraPose> estimateMovedPose(const Camera& camera, const CameraMotionPrior& prior,
                                          std::span<const PointSighting> sightings);

} // namespace dewpoint::calibration
