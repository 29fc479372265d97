// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/geometry/camera.h"

#include <Eigen/Core>

#include <span>

namespace dewpoint::calibration {

/// Point whose position is known from the other cameras, and its pixel in the camera that was
/// moved.
struct PointSighting {
  Eigen::Vector3d world = Eigen::Vector3d::Zero(); ///< position, meters
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double sigmaPixels = 1.0; ///< standard deviation of `pixel` and the projected point combined
};

/// Prior knowledge of a camera motion, before the points are used.
struct CameraMotionPrior {
  Eigen::Vector3d turn =
      Eigen::Vector3d::Zero(); ///< measured rotation, as in CameraRotation; radians
  double rotationSigma =
      2e-4; ///< standard deviation of the rotation, which is measured from the background; radians
  double shiftSigma = 0.01; ///< standard deviation of a possible displacement of the camera; meters
};

/// New pose of a camera that was moved.
struct MovedCameraPose {
  Camera camera;
  int used = 0;              ///< number of sightings that agree within three sigma
  double pixelsBefore = 0.0; ///< median distance of all sightings from their projections with the
                             ///< old pose; 0 without sightings
  double pixelsAfter = 0.0;  ///< median distance with the new pose
  Eigen::Vector3d angleSigma =
      Eigen::Vector3d::Zero(); ///< standard deviation of the rotation, radians, camera axes
  Eigen::Vector3d shiftSigma =
      Eigen::Vector3d::Zero(); ///< standard deviation of the position, meters, camera axes
};

/// Returns the camera rotated about its center. To first order, this is (1 + [turn]x)
/// cameraFromWorld; the rotation used is exact.
Camera rotatedCamera(const Camera& camera, const Eigen::Vector3d& turn);

/// Estimates the pose of one camera that was moved, while all other cameras and its intrinsics stay
/// fixed. Least squares (Ceres) over the six pose parameters, from the sightings (Huber loss at two
/// sigma) and the prior. A displaced camera also appears to rotate relative to its background, by
/// displacement over distance. The prior's rotation is therefore assumed to be known to within
/// rotationSigma and shiftSigma at 3 m combined. Without sightings, the result is the old camera,
/// rotated. Error: Mismatch if the sightings contradict the result (fewer than half agree).
Result<MovedCameraPose> estimateMovedPose(const Camera& camera, const CameraMotionPrior& prior,
                                          std::span<const PointSighting> sightings);

} // namespace dewpoint::calibration
