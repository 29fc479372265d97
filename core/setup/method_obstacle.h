// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::project {
struct Project;
} // namespace dewpoint::project
namespace dewpoint::tracking {
struct Method;
} // namespace dewpoint::tracking

namespace dewpoint::setup {

/// Reason why a method cannot work with a project.
enum class MethodObstacle {
  None,
  NoCalibration, ///< the method requires calibrated cameras
  TooFewCameras  ///< the method needs more cameras to find a target (MethodFamily::minCameraCount)
};

/// Returns what prevents a method from working with the cameras of a project, regardless of the
/// project's own method. A guessed calibration (hasGuessedPose()) of several cameras is sufficient
/// for methods that use colors, since such methods can still display the content of the images. It
/// is not sufficient for a single camera, or for methods that search for people on the floor.
MethodObstacle methodObstacle(const Project& project, const Method& method);

} // namespace dewpoint::setup
