// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/random_draws.h"
#include "core/geometry/camera.h"
#include "core/simulation/body/usual_ball.h"
#include "core/simulation/people/walker.h"
#include "core/simulation/room/room.h"

#include <vector>

namespace dewpoint::experiment::scenarios {

/// Draws a room for the grade (level of realism) `wild`. The room contains clutter of any shape,
/// size and color, which is kept away from the cameras and from the center of their common volume.
/// It also has posters, walls of another color and a lamp at another position. Some of the clutter
/// has approximately the target color (BGR in full light).
simulation::RoomDesign
randomRoom(simulation::Furnishing furnishing, const CameraRig& rig, RandomDraws& draws,
           const Eigen::Vector3d& targetColor = simulation::kDefaultBallColor);

/// Draws up to three people who walk along two walls of a room with a desk during a run of
/// `seconds`, beyond the desk and the cameras. Some wear the target color. Returns no people for
/// the hall, because the volume of the targets extends to its walls.
std::vector<simulation::Walker>
randomPeople(simulation::Furnishing furnishing, double seconds, RandomDraws& draws,
             const Eigen::Vector3d& targetColor = simulation::kDefaultBallColor);

/// Returns the world z of a room's floor, meters.
float floorHeightOf(simulation::Furnishing furnishing);

} // namespace dewpoint::experiment::scenarios
