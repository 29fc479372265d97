// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/world_box.h"

#include <cstddef>
#include <optional>

namespace dewpoint::geometry {

/// Meters to which one camera alone is taken to see, which nothing else tells. Chosen: the size of
/// a room.
inline constexpr double kReachOfOneCamera = 4.0;

/// The box around what at least `cameras` cameras of a rig see together, each up to half as far
/// again as where its optical axis meets those of the others (the median), and at most 20 times as
/// far as the cameras are apart; up to kReachOfOneCamera where the cameras tell no distance.
/// Cameras without an image size or a focal length do not count. Nothing where that
/// number of cameras sees nothing together.
///
/// Sampled: the box is that of points on a lattice of each camera's rays, a tenth of its view's
/// width and 3 % of its depth apart. Takes a few milliseconds for eight cameras.
std::optional<WorldBox> commonVolume(const CameraRig& rig, std::size_t cameras);

/// The common volume of two cameras; that of one where no two see anything together. Nothing
/// without a camera that counts.
std::optional<WorldBox> seenVolume(const CameraRig& rig);

} // namespace dewpoint::geometry
