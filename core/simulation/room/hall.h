// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/room/furniture.h"

namespace dewpoint::simulation {

/// Adds the furniture of a living room with a free center, for Furnishing::Hall.
void furnishHall(Furniture& room);

} // namespace dewpoint::simulation
