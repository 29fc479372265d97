// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/world_box.h"
#include "core/project/project.h"

#include <optional>

namespace dewpoint::setup {

/// Returns the bounding box of what at least two cameras of a project see, or of what single
/// cameras see if no two views overlap, as geometry::seenVolume(): meters, world frame. Returns
/// nothing without a calibrated camera.
std::optional<WorldBox> volumeSeenBy(const Project& project);

} // namespace dewpoint::setup
