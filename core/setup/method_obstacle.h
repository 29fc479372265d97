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

/// Why a method cannot work with a project.
enum class MethodObstacle {
  None,
  NoCalibration, ///< it needs to know where the cameras stand
  TooFewCameras  ///< it finds nothing with so few of them (MethodFamily::fewestCameras)
};

/// What keeps a method from working with the cameras of a project, whatever its own method is. A
/// guessed calibration (isGuessed()) of several cameras will do for methods that go by colors: they
/// show what the images hold. For one camera, and for methods that look for people on the floor, it
/// will not.
MethodObstacle methodObstacle(const Project& project, const Method& method);

} // namespace dewpoint::setup
