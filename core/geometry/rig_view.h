// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace dewpoint::geometry {

/// Returns the point at which a rig is aimed: the point nearest to all optical axes (world,
/// meters). If the axes do not determine the distance (a single camera, or parallel axes), the
/// point is two meters in front of the cameras. If no camera has a pose, the point is the world
/// origin.
Eigen::Vector3d rigAimPoint(const CameraRig& rig);

/// Returns a box (world, meters) around the cameras and the point at which the cameras are aimed.
/// The box is empty if no camera has a pose.
Eigen::AlignedBox3d rigBounds(const CameraRig& rig);

/// How much a rig differs from an earlier calibration of the same project. The change determines
/// whether the user's 3D view of the earlier rig still suits the new rig.
enum class RigChange {
  /// At most one camera was adjusted. The size and position of the rig are about the same.
  OneCamera,
  /// Refined calibration: the same cameras in a room of about the same size.
  Refined,
  /// Different cameras, or the same cameras in a room of a different size or at a different
  /// position. A view of the earlier rig does not suit the new rig.
  Elsewhere
};

/// Returns the kind of change from the calibration `before` to the calibration `now`.
RigChange rigChange(const CameraRig& before, const CameraRig& now);

} // namespace dewpoint::geometry
