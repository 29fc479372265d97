// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/intrinsics_from_board.h"
#include "core/project/project.h"

#include <optional>
#include <vector>

namespace dewpoint {

/// The project with these cameras' calibration, in the same order.
Project withCameras(Project project, const CameraRig& rig);

/// The project with these lenses, in the order of its cameras, which keep theirs where there is
/// none; poses stay.
Project withIntrinsics(Project project,
                       const std::vector<std::optional<IntrinsicsResult>>& results);

} // namespace dewpoint
