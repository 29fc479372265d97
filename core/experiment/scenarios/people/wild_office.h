// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/random_draws.h"
#include "core/geometry/camera.h"
#include "core/simulation/people/office.h"
#include "core/simulation/room/room.h"

namespace dewpoint::experiment {

/// The office of a run of grade `Wild`, and the cameras in it.
struct WildOffice {
  CameraRig rig;
  simulation::RoomDesign design;
};

/// Cameras put up by somebody else (along the walls, lower or higher, with other lenses and another
/// aim), walls of another color, posters on them, some of the color of somebody's shirt, and the
/// lamp elsewhere. Who walks where stays.
WildOffice wildOffice(const OfficeScene& scene, Draws& draws);

} // namespace dewpoint::experiment
