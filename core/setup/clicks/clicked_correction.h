// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/filter/gaussian.h"
#include "core/project/project.h"

#include <cstdint>
#include <optional>

namespace dewpoint::setup {

/// Returns the project's correction of this target (index in Project::targets) in this frame; null
/// if there is none.
const PositionCorrection* correctionAt(const Project& project, std::int64_t frame, int target);

/// Creates the correction of a target in frame `frame` after the user has clicked on the target
/// once more, in the image of a camera of `rig`. It contains the clicks of the existing correction
/// in this frame and the new `click`, which replaces an earlier click in the same camera. The
/// position is the positionFromClicks() of all these clicks. With one click, the position is at the
/// depth of `estimate` (the target's estimate in this frame). With several clicks, it is where
/// their rays meet. Returns the errors of positionFromClicks().
Result<PositionCorrection> correctionFromClick(const Project& project, const CameraRig& rig,
                                               std::int64_t frame, int target,
                                               const PointClick& click,
                                               const std::optional<Gaussian3>& estimate);

} // namespace dewpoint::setup
