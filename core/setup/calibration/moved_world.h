// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/world/world_frame.h"
#include "core/project/project.h"

namespace dewpoint::setup {

/// Returns the project in another world frame. `change` converts old world coordinates to new ones.
/// It is applied to the cameras and to everything else in the project that has world coordinates:
/// the reference grid, the measured points, the volume of interest, start volumes and areas that
/// the user entered, and the corrections of positions and people.
///
/// A box with edges parallel to the axes is replaced by the smallest box with edges parallel to the
/// new axes that contains it. The reference grid stays horizontal. The radii of targets are not
/// scaled, because they were measured with a ruler. The ground truth of a recording is a file and
/// keeps its own frame.
Project withMovedWorld(Project project, const Similarity& change);

} // namespace dewpoint::setup
