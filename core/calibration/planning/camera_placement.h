// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/bundle/calibration_progress.h"
#include "core/geometry/camera.h"

#include <Eigen/Geometry>

#include <string>

namespace dewpoint::calibration {

/// Returns a camera without distortion, with its principal point at the center of the image.
/// `fieldOfView` is horizontal, in radians.
Camera idealCamera(const std::string& name, int width, int height, double fieldOfView);

/// Returns the camera with a pose in one of the upper corners of the volume, looking at the center
/// of the volume. The corner is the one farthest from all cameras in the rig. This is the start
/// pose of a planned camera. If several corners are equally distant, the first one in Eigen's order
/// of corners is used.
Camera placedInFarthestCorner(Camera camera, const CameraRig& rig,
                              const Eigen::AlignedBox3d& volume);

/// Settings of placeCamera(), which finds the best pose for an additional camera.
struct PlacementSettings {
  Eigen::AlignedBox3d volume; ///< volume to measure in; world frame, meters
  /// Distance by which the walls and the ceiling lie outside the volume, meters.
  double wallDistance = 0.0;
  double pixelSigma = 0.5; ///< standard deviation of an image measurement, pixels
  /// Largest standard deviation with which a position counts as good enough, meters.
  double maxGoodSigma = 0.005;
  std::size_t cellCount = 900; ///< number of cells into which the volume is divided for the search
  /// Number of cells used to compute the fractions of the volume in PlacedCamera; 0: the same cells
  /// as for the search. To make the fractions agree with a displayed map, set the number of cells
  /// of that map.
  std::size_t reportedCellCount = 0;
};

/// Result of placeCamera(): an additional camera in its best pose, and how much it improves a rig.
struct PlacedCamera {
  Camera camera; ///< the given camera in its new pose
  /// Fraction of the volume (0 to 1) in which positions are measured with a standard deviation of
  /// at most maxGoodSigma, without the new camera.
  double goodVolumeFractionBefore = 0.0;
  /// Fraction of the volume (0 to 1) in which positions are measured with a standard deviation of
  /// at most maxGoodSigma, with the new camera.
  double goodVolumeFractionAfter = 0.0;
};

/// Finds the best pose for an additional camera: on one of the four walls (in the upper half) or on
/// the ceiling of the volume, looking into it. The score of a pose is the mean of 1 / (1 + (sigma /
/// maxGoodSigma)²) over the volume, plus a small amount for each part that is visible. This amount
/// decides where the first camera is placed, because a single camera does not measure positions.
/// All poses on a coarse grid, aimed at the center and at four points around it, are compared. The
/// best one is then moved and rotated in decreasing steps as long as it improves. The same input
/// produces the same pose. Errors: BadValue for a volume without extent or a lens without focal
/// length; Canceled.
Result<PlacedCamera> placeCamera(const CameraRig& rig, const Camera& lens,
                                 const PlacementSettings& settings,
                                 const CalibrationProgress& progress = {});

} // namespace dewpoint::calibration
