// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/world_box.h"

#include <cstddef>
#include <optional>

namespace dewpoint::geometry {

/// Distance in meters up to which cameras are assumed to see if all of them are at one position.
/// The value is about the size of a room and was chosen by judgment.
inline constexpr double kSingleCameraRange = 4.0;

/// Returns the bounding box of the volume in which each point is seen by at least `cameras` cameras
/// of a rig (world frame, meters). Returns nothing if there is no such volume. Cameras without an
/// image size or a focal length are ignored.
///
/// Each camera is assumed to see up to a limited distance. The limit is 1.5 times the median of the
/// distances at which the optical axis of the camera meets the optical axes of the other cameras.
/// The limit is never more than 20 times the largest distance between two cameras. If all cameras
/// are at one position, the limit is kSingleCameraRange instead.
///
/// The box is computed from sample points along a grid of rays from each camera. The spacing of the
/// points is a tenth of the width of the camera's view, and 3 % of the distance up to which the
/// camera sees. The computation takes a few milliseconds for eight cameras.
std::optional<WorldBox> commonVolume(const CameraRig& rig, std::size_t cameras);

/// Returns the bounding box (world frame, meters) of the volume that at least two cameras see. If
/// there is no such volume, returns the box of the volume that at least one camera sees. Returns
/// nothing if no camera has an image size and a focal length.
std::optional<WorldBox> seenVolume(const CameraRig& rig);

} // namespace dewpoint::geometry
