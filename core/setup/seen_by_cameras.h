// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/world_box.h"
#include "core/project/project.h"

#include <optional>

namespace dewpoint::setup {

/// The box around what at least two cameras of a project see, of one camera where no two see
/// anything together, as geometry::seenVolume(): meters, world. Nothing without a calibrated
/// camera.
std::optional<WorldBox> volumeSeenBy(const Project& project);

} // namespace dewpoint::setup
