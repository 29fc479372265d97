// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/random_draws.h"
#include "core/geometry/camera.h"
#include "core/simulation/room/room.h"

namespace dewpoint::experiment::scenarios {

/// Cameras of grade `wild`, and the scales of the scene that they require.
struct WildRig {
  CameraRig rig;
  double radiusScale = 1.0; ///< factor of the balls' radius, so that they can be small in images
  double pathScale = 1.0;   ///< factor of smooth paths, so that they stay in the images
};

/// Number of rigs that are drawn before a scenario finds no position; chosen: few, because each
/// requires rendering a room.
inline constexpr int kMostRigs = 6;

/// Draws another rig than a scenario's own. Each camera is moved by up to 0.3 radians around the
/// center of the volume and by 15 % in distance, and is tilted. Its focal length and resolution are
/// such that a target in the center measures from 4 pixels to half of the image, uniformly in the
/// logarithm. With each attempt (0 to kMostRigs - 1) the largest targets come closer to their usual
/// size.
WildRig drawRig(const CameraRig& rig, simulation::Furnishing furnishing, int attempt, Draws& draws);

} // namespace dewpoint::experiment::scenarios
