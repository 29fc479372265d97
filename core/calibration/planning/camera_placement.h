// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/bundle/calibration_progress.h"
#include "core/geometry/camera.h"

#include <Eigen/Geometry>

#include <string>

namespace dewpoint::calibration {

/// A camera without distortion, its principal point at the center of the image. `fieldOfView`:
/// horizontal, radians.
Camera idealCamera(const std::string& name, int width, int height, double fieldOfView);

/// The camera in that upper corner of the volume which is farthest from all cameras of the rig,
/// looking at the volume's center: where a planned camera begins. Of corners as far, the first one
/// in Eigen's order.
Camera inFarthestCorner(Camera camera, const CameraRig& rig, const Eigen::AlignedBox3d& volume);

struct PlacementSettings {
  Eigen::AlignedBox3d volume;  ///< to measure in; world, meters
  double wallDistance = 0.0;   ///< walls and ceiling are this far outside of it, meters
  double pixelSigma = 0.5;     ///< of a sighting, pixels
  double goodSigma = 0.005;    ///< what is good enough, meters
  std::size_t cellCount = 900; ///< that the volume is cut into during the search for a position
  /// The result's numbers are measured on this number of cells, those of a map that is shown, so
  /// that the figures agree; 0: on those of the search.
  std::size_t reportedCells = 0;
};

/// The pose that was found.
struct Placement {
  Camera camera;             ///< as given, with its pose
  double withinBefore = 0.0; ///< share of the volume that is good enough without it, 0 to 1
  double withinAfter = 0.0;
};

/// The best pose for one more camera: on one of the four walls (in the upper half) or on the
/// ceiling of the volume, looking into it. A pose is worth the mean over the volume of 1 / (1 +
/// (sigma / goodSigma)²), and a little for what is seen at all, which decides for the first camera.
/// All poses of a coarse raster, aimed at the center and at four points around it, are compared;
/// the best one is then moved and rotated in shrinking steps as long as it gets better. The same
/// input gives the same pose. BadValue for a volume without extent or a lens without focal length;
/// Cancelled.
Result<Placement> placeCamera(const CameraRig& rig, const Camera& lens,
                              const PlacementSettings& settings,
                              const CalibrationProgress& progress = {});

} // namespace dewpoint::calibration
