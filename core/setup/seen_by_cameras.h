// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/world_box.h"
#include "core/project/project.h"

#include <optional>

namespace dewpoint::setup {

/// The box around what the cameras of a project see together, as geometry::seenVolume(): meters,
/// world. Nothing without a calibrated camera.
std::optional<WorldBox> volumeSeenBy(const Project& project);

} // namespace dewpoint::setup
