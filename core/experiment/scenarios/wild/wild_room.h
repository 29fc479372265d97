// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/random_draws.h"
#include "core/geometry/camera.h"
#include "core/simulation/body/usual_ball.h"
#include "core/simulation/people/walker.h"
#include "core/simulation/room/room.h"

#include <vector>

namespace dewpoint::experiment::scenarios {

/// Draws furniture of grade `wild`: clutter of any shape, size and color that stays clear of the
/// center of the volume and of the cameras, posters, walls of another color and a lamp at another
/// position. Some of it has approximately the target's color (BGR in full light).
simulation::RoomDesign drawRoom(simulation::Furnishing furnishing, const CameraRig& rig,
                                Draws& draws,
                                const Eigen::Vector3d& targetColor = simulation::kUsualBallColor);

/// Draws up to three people who walk along two walls of a room with a desk, behind the cameras'
/// volume, for a run of `seconds`. Some wear the target's color. The hall has no people, because
/// its volume reaches its walls.
std::vector<simulation::Walker>
drawPeople(simulation::Furnishing furnishing, double seconds, Draws& draws,
           const Eigen::Vector3d& targetColor = simulation::kUsualBallColor);

/// World z of the floor of a room, meters.
float floorOf(simulation::Furnishing furnishing);

} // namespace dewpoint::experiment::scenarios
