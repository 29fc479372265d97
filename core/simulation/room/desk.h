// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/room/furniture.h"

namespace dewpoint::simulation {

/// Furnishing::Desk: adds the desk, and pictures on the walls behind it.
void furnishDesk(Furniture& room);
/// Furnishing::ClutteredDesk: adds the objects on that desk.
void clutterDesk(Furniture& room);

} // namespace dewpoint::simulation
