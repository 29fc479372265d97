// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/filter/gaussian.h"
#include "core/project/project.h"

#include <cstdint>
#include <optional>

namespace dewpoint::setup {

/// The project's correction of this target (index in Project::targets) at this frame; null when
/// there is none.
const PositionCorrection* correctionAt(const Project& project, std::int64_t frame, int target);

/// The correction of a target that one more click on it makes, in the image of a camera of `rig` at
/// this frame: with the clicks of the one there is, this one in place of an earlier one of its
/// camera. Its position is the clickedPosition() of them all: of one click as far from the camera
/// as `estimate` is, the target's at this frame; of more, where their rays meet. Errors as there.
Result<PositionCorrection> clickedCorrection(const Project& project, const CameraRig& rig,
                                             std::int64_t frame, int target,
                                             const PointClick& click,
                                             const std::optional<Gaussian3>& estimate);

} // namespace dewpoint::setup
