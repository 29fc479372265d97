// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/people/office.h"

namespace dewpoint::simulation {

/// Name of the built-in scene of people, which a project can use like the scenes of balls.
inline constexpr const char* kOfficeScene = "office";

/// Returns half a minute in the simulated office: three people in different clothes enter through
/// doors, two of them meet and talk, all cross the room and leave. It is empty for the first 1.5 s.
OfficeScene officeDay();

} // namespace dewpoint::simulation
