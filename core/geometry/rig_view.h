// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace dewpoint::geometry {

/// The point nearest to all optical axes: what a rig is aimed at. For a single camera (or parallel
/// axes) two meters before the cameras; the origin without a camera that has a pose.
Eigen::Vector3d aimOf(const CameraRig& rig);

/// Around the cameras and what they are aimed at; empty without a camera that has a pose.
Eigen::AlignedBox3d boxAround(const CameraRig& rig);

/// How much of what was seen of a rig still holds after its calibration has changed.
enum class RigChange {
  /// At most one camera was adjusted, and the rig is about as large as it was and at about the same
  /// position.
  OneCamera,
  /// The same cameras in a room of about the same size: a refined calibration.
  Refined,
  /// Other cameras, or the same ones in a room of another size or position: what was looked at in
  /// one is nothing in the other.
  Elsewhere
};

RigChange rigChange(const CameraRig& before, const CameraRig& now);

} // namespace dewpoint::geometry
