// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/people/office.h"

namespace dewpoint::simulation {

/// Name of the built-in scene of people: a project may name it as it names the scenes of balls.
inline constexpr const char* kOfficeScene = "office";

/// Half a minute in the simulated office: three people in different clothes come in through doors,
/// two of them meet and talk, all cross, and leave. Nobody is there in the first 1.5 s.
OfficeScene officeDay();

} // namespace dewpoint::simulation
