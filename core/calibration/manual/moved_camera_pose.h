// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/geometry/camera.h"

#include <Eigen/Core>

#include <span>

namespace dewpoint::calibration {

/// Where a point, known from the other cameras, is seen by the camera that was moved.
struct PointSighting {
  Eigen::Vector3d world = Eigen::Vector3d::Zero(); ///< meters
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double sigmaPixels = 1.0; ///< of the pixel and of the point as projected, together
};

/// What is known of a camera motion before the points are used.
struct CameraMotionPrior {
  Eigen::Vector3d turn = Eigen::Vector3d::Zero(); ///< as CameraRotation, radians
  double turnSigma = 2e-4;  ///< of the rotation as measured by the background; radians
  double shiftSigma = 0.01; ///< how far the camera may have been pushed aside; meters
};

/// A moved camera, solved again.
struct MovedCameraPose {
  Camera camera;
  int used = 0;              ///< sightings that agree, within three sigma
  double pixelsBefore = 0.0; ///< median distance of all sightings, with the old pose; 0 without any
  double pixelsAfter = 0.0;  ///< with the new one
  Eigen::Vector3d angleSigma = Eigen::Vector3d::Zero(); ///< rad, camera axes, at one sigma
  Eigen::Vector3d shiftSigma = Eigen::Vector3d::Zero(); ///< meters, camera axes
};

/// The camera rotated about its center: (1 + [turn]x) cameraFromWorld, the turn as a whole
/// rotation.
Camera rotatedCamera(const Camera& camera, const Eigen::Vector3d& turn);

/// The pose of one camera that was moved; all others, and its lens, stay. Least squares (Ceres)
/// over its six numbers: sightings (Huber's loss at two sigma) and the prior. Before its
/// background, a camera that is pushed aside seems rotated too, by shift over distance: the prior's
/// rotation is therefore taken to be known within turnSigma and shiftSigma at 3 m together. Without
/// sightings the result is the old camera, rotated. Mismatch when the sightings contradict the
/// result (less than half agree).
Result<MovedCameraPose> estimateMovedPose(const Camera& camera, const CameraMotionPrior& prior,
                                          std::span<const PointSighting> sightings);

} // namespace dewpoint::calibration
