// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/world_box.h"

#include <cstddef>
#include <optional>

namespace dewpoint::geometry {

/// Assumed range of a single camera, meters, used when the rig itself implies no distance. Chosen
/// to be about the size of a room.
inline constexpr double kSingleCameraRange = 4.0;

/// Returns the bounding box of the volume that at least `cameras` cameras of a rig see. World
/// frame, meters. Each camera is assumed to see up to 1.5 times the distance at which its optical
/// axis meets those of the others (the median), and at most 20 times the largest distance between
/// two cameras. If the cameras imply no distance, the limit is kSingleCameraRange. Cameras without
/// an image size or a focal length do not count. Nothing if no volume is seen by that number of
/// cameras.
///
/// The box is computed from sample points on a lattice of each camera's rays. The spacing is a
/// tenth of the width of the view and 3 % of its depth. The computation takes a few milliseconds
/// for eight cameras.
std::optional<WorldBox> commonVolume(const CameraRig& rig, std::size_t cameras);

/// Returns the volume seen by at least two cameras, or by one camera if no two cameras see a common
/// volume. Nothing if no camera counts.
std::optional<WorldBox> seenVolume(const CameraRig& rig);

} // namespace dewpoint::geometry
