// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/world_box.h"
#include "core/project/project.h"

#include <optional>

namespace dewpoint::setup {

/// Returns the bounding box of the volume that at least two cameras of a project see, in meters,
/// world frame; see geometry::seenVolume(). If no two views overlap, the box covers the volumes
/// seen by single cameras. Returns nothing if no camera is calibrated.
std::optional<WorldBox> volumeSeenByCameras(const Project& project);

} // namespace dewpoint::setup
