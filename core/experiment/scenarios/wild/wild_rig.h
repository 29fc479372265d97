// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/random_draws.h"
#include "core/geometry/camera.h"
#include "core/simulation/room/room.h"

namespace dewpoint::experiment::scenarios {

/// Cameras of grade `wild`, and what they make of the scene.
struct WildRig {
  CameraRig rig;
  double radiusScale = 1.0; ///< of the balls, so that they can be small in the images
  double pathScale = 1.0;   ///< of the smooth paths, so that they stay in the images
};

/// How often another rig is drawn when a scenario finds no position in one; chosen: few, as
/// each needs a room to be rendered.
inline constexpr int kMostRigs = 6;

/// Another rig than a scenario's own: each camera elsewhere by up to 0.3 radians around the middle
/// of the volume and 15 % in distance, tilted, and with a focal length and a resolution for which a
/// target in the middle measures from 4 pixels to half of the image, evenly in the logarithm. From
/// attempt to attempt (0 to kMostRigs - 1) the largest targets come nearer to their usual size.
WildRig drawRig(const CameraRig& rig, simulation::Furnishing furnishing, int attempt, Draws& draws);

} // namespace dewpoint::experiment::scenarios
