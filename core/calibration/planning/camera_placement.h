// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/bundle/calibration_progress.h"
#include "core/geometry/camera.h"

#include <Eigen/Geometry>

#include <string>

namespace dewpoint::calibration {

/// Camera without distortion, with its principal point at the center of the image. `fieldOfView`:
/// horizontal, radians.
Camera idealCamera(const std::string& name, int width, int height, double fieldOfView);

/// Places the camera in the upper corner of the volume that is farthest from all cameras of the
/// rig, looking at the center of the volume: the start pose of a planned camera. Of equally distant
/// corners, the first in Eigen's order is used.
Camera inFarthestCorner(Camera camera, const CameraRig& rig, const Eigen::AlignedBox3d& volume);

/// Settings of placeCamera().
struct PlacementSettings {
  Eigen::AlignedBox3d volume;  ///< volume to be measured; world, meters
  double wallDistance = 0.0;   ///< distance of walls and ceiling from the volume, outwards; meters
  double pixelSigma = 0.5;     ///< standard deviation of a sighting, pixels
  double goodSigma = 0.005;    ///< standard deviation that is good enough, meters
  std::size_t cellCount = 900; ///< number of cells of the volume during the search
  /// Number of cells on which the result's numbers are computed. The cells of a displayed map make
  /// the numbers agree with it; 0: the cells of the search.
  std::size_t reportedCells = 0;
};

/// Result of placeCamera().
struct Placement {
  Camera camera; ///< the given camera with its new pose
  double withinBefore =
      0.0; ///< share of the volume that is good enough without the new camera, 0 to 1
  double withinAfter = 0.0; ///< the same share with the new camera
};

/// The best pose for one more camera: on one of the four walls (in the upper half) or on the
/// ceiling of the volume, looking into it. A pose is worth the mean over the volume of 1 / (1 +
/// (sigma / goodSigma)²), and a little for what is seen at all, which decides for the first camera.
/// All poses of a coarse raster, aimed at the center and at four points around it, are compared;
/// the best one is then moved and rotated in shrinking steps as long as it gets better. The same
/// input gives the same pose. BadValue for a volume without extent or a lens without focal length;
/// Canceled.
Result<Placement> placeCamera(const CameraRig& rig, const Camera& lens,
                              const PlacementSettings& settings,
                              const CalibrationProgress& progress = {});

} // namespace dewpoint::calibration
