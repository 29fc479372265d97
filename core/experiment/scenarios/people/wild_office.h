// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/random_draws.h"
#include "core/geometry/camera.h"
#include "core/simulation/people/office.h"
#include "core/simulation/room/room.h"

namespace dewpoint::experiment {

/// Office of a run of grade `Wild`, and its cameras.
struct WildOffice {
  CameraRig rig;
  simulation::RoomDesign design;
};

/// Makes an office of grade `Wild`: cameras mounted differently (along the walls, lower or higher,
/// with other lenses and aimed elsewhere), walls of another color, posters, some of them in the
/// color of a person's shirt, and the lamp at another position. The paths of the people do not
/// change.
WildOffice wildOffice(const OfficeScene& scene, Draws& draws);

} // namespace dewpoint::experiment
