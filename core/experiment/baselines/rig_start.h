// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/scenario.h"
#include "core/tracking/start_parameters.h"

#include <optional>

namespace dewpoint::experiment {

/// What all cameras of a rig see together (geometry::commonVolume), or two of them where there is
/// nothing that all see. Nothing for fewer than two cameras, or when no two see anything together.
std::optional<StartVolume> commonView(const CameraRig& rig);

/// Where a method starts that would otherwise start on the desk of its paper: in the part of the
/// run's start volume that the cameras see together; when the run's start is a point, in all that
/// they see together. The run's own start volume where both have nothing in common.
StartVolume startFromRig(const ScenarioRun& run);

} // namespace dewpoint::experiment
