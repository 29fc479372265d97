// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/random_draws.h"
#include "core/geometry/camera.h"
#include "core/simulation/body/usual_ball.h"
#include "core/simulation/people/walker.h"
#include "core/simulation/room/room.h"

#include <vector>

namespace dewpoint::experiment::scenarios {

/// Furniture of grade `wild`: clutter of any shape, size and color that stands clear of the middle
/// of the volume and of the cameras, posters, walls of another color and a lamp that hangs
/// elsewhere. Some of it has about the target's color (BGR in full light).
simulation::RoomDesign drawRoom(simulation::Furnishing furnishing, const CameraRig& rig,
                                Draws& draws,
                                const Eigen::Vector3d& targetColor = simulation::kUsualBallColor);

/// None to three people who walk along two walls of a room with a desk, behind the cameras' volume,
/// while a run of `seconds` lasts; some wear the target's color. Nobody in the hall, whose volume
/// reaches its walls.
std::vector<simulation::Walker>
drawPeople(simulation::Furnishing furnishing, double seconds, Draws& draws,
           const Eigen::Vector3d& targetColor = simulation::kUsualBallColor);

/// World z of the floor of a room, meters.
float floorOf(simulation::Furnishing furnishing);

} // namespace dewpoint::experiment::scenarios
