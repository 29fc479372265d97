// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/room/furniture.h"

namespace dewpoint::simulation {

/// Adds a desk, and pictures on the walls behind the desk, for Furnishing::Desk.
void furnishDesk(Furniture& room);
/// Adds the objects that lie on the desk, for Furnishing::ClutteredDesk.
void clutterDesk(Furniture& room);

} // namespace dewpoint::simulation
