// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/scenario.h"
#include "core/tracking/start_parameters.h"

#include <optional>

namespace dewpoint::experiment {

/// Returns the volume that all cameras of a rig see (geometry::commonVolume). If there is none,
/// returns a volume that at least two cameras see. Returns nothing if there are fewer than two
/// cameras, or if no two cameras see a common volume.
std::optional<StartVolume> commonViewVolume(const CameraRig& rig);

/// Returns the start volume for a method that would otherwise start on the desk described in its
/// paper. It is the part of the run's start volume that lies in the volume seen by the cameras
/// (commonViewVolume()). If the run starts at a point, it is the whole commonViewVolume(). If the
/// two volumes do not intersect, or if there is no common volume, it is the run's start volume.
StartVolume startVolumeFromRig(const ScenarioRun& run);

} // namespace dewpoint::experiment
