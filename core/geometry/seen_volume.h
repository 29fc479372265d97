// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/world_box.h"

#include <cstddef>
#include <optional>

namespace dewpoint::geometry {

/// Distance in meters up to which cameras are assumed to see if all cameras are at one position.
/// About the size of a room; chosen by judgment.
inline constexpr double kSingleCameraRange = 4.0;

/// Returns the bounding box of the volume that at least `cameras` cameras of a rig see (world
/// frame, meters). Returns nothing if there is no such volume. Cameras without an image size or a
/// focal length do not count.
///
/// Each camera is assumed to see up to a limited distance. The limit is 1.5 times the median of the
/// distances at which its optical axis meets those of the other cameras. It is never more than 20
/// times the largest distance between two cameras, or kSingleCameraRange if that distance is 0.
///
/// The box is computed from sample points on a lattice of each camera's rays. Their spacing is a
/// tenth of the width of the camera's view, and 3 % of its depth. The computation takes a few
/// milliseconds for eight cameras.
std::optional<WorldBox> commonVolume(const CameraRig& rig, std::size_t cameras);

/// Returns the bounding box of the volume that at least two cameras see, or, if there is none, of
/// the volume that at least one camera sees. Returns nothing if no camera counts.
std::optional<WorldBox> seenVolume(const CameraRig& rig);

} // namespace dewpoint::geometry
