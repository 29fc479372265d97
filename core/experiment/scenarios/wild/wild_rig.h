// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/random_draws.h"
#include "core/geometry/camera.h"
#include "core/simulation/room/room.h"

namespace dewpoint::experiment::scenarios {

/// Cameras for a run of the grade (level of realism) `wild`, and the scale factors of the scene
/// that they require.
struct WildRig {
  CameraRig rig;
  /// Scale factor for ball radii; below 1 if balls should appear small in the images.
  double radiusScale = 1.0;
  double pathScale = 1.0; ///< scale factor for smooth paths, which must stay inside the images
};

/// Number of rigs that are drawn before a scenario gives up. It is small because each rig requires
/// rendering a room.
inline constexpr int kMaxRigAttempts = 6;

/// Draws a random rig for the grade (level of realism) `wild` from the scenario's rig. Each camera
/// is moved by up to 0.3 radians around the center of the volume and by up to 15 % in distance, and
/// is tilted. The width of a target in the images is drawn from 4 pixels to half of the image's
/// smaller side (log-uniform), and focal length, resolution and ball size are chosen accordingly.
/// With each `attempt` (0 to kMaxRigAttempts - 1), a target that would appear larger than usual
/// comes closer to its usual size.
WildRig randomRig(const CameraRig& rig, simulation::Furnishing furnishing, int attempt,
                  RandomDraws& draws);

} // namespace dewpoint::experiment::scenarios
