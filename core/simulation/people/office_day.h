// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/people/office.h"

namespace dewpoint::simulation {

/// Name of the built-in scene with people. A project can use this scene like the scenes with balls.
inline constexpr const char* kOfficeSceneName = "office";

/// Returns a scene of half a minute in the simulated office. Three people in different clothes
/// enter through doors, two people meet and talk, and all three cross the room and leave. There are
/// no people for the first 1.5 s.
OfficeScene builtInOfficeScene();

} // namespace dewpoint::simulation
