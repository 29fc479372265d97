// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/scenario.h"
#include "core/tracking/start_parameters.h"

#include <optional>

namespace dewpoint::experiment {

/// Returns the volume that all cameras of a rig see (geometry::commonVolume) or, if there is none,
/// a volume that at least two cameras see. Returns nothing if no two cameras see a common volume.
std::optional<StartVolume> commonViewVolume(const CameraRig& rig);

/// Returns the volume in which a method starts to search. This is the part of the run's start
/// volume that the cameras see (commonViewVolume()); if the run starts at a point, the whole
/// commonViewVolume(). If there is no common volume, or if the two volumes do not intersect, it is
/// the run's start volume. Use it for methods that would otherwise start on the desk described in
/// their paper.
StartVolume startVolumeFromRig(const ScenarioRun& run);

} // namespace dewpoint::experiment
