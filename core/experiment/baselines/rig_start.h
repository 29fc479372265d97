// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/scenario.h"
#include "core/tracking/start_parameters.h"

#include <optional>

namespace dewpoint::experiment {

/// Volume that all cameras of a rig see together (geometry::commonVolume), or two of them if no
/// volume is seen by all. Nothing for fewer than two cameras, or if no two see a common volume.
std::optional<StartVolume> commonView(const CameraRig& rig);

/// Start volume for a method that would otherwise start on the desk of its paper: the part of the
/// run's start volume that the cameras see together. If the run's start is a point, it is all that
/// they see together. If the two volumes do not intersect, it is the run's own start volume.
StartVolume startFromRig(const ScenarioRun& run);

} // namespace dewpoint::experiment
