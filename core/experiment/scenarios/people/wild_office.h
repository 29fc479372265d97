// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/random_draws.h"
#include "core/geometry/camera.h"
#include "core/simulation/people/office.h"
#include "core/simulation/room/room.h"

namespace dewpoint::experiment {

/// Office and cameras for a run of the grade (level of realism) `Wild`.
struct WildOffice {
  CameraRig rig;
  simulation::RoomDesign design;
};

/// Returns the office of a scene, changed for the grade (level of realism) `Wild`:
/// - The cameras are moved along the walls, mounted lower or higher, aimed elsewhere, and have
///   other lenses.
/// - The walls have another color, and the lamp is at another position.
/// - There are posters, some of them in the color of a person's shirt.
///
/// The paths of the people do not change.
WildOffice makeWildOffice(const OfficeScene& scene, RandomDraws& draws);

} // namespace dewpoint::experiment
