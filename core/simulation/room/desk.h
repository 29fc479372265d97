// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/room/furniture.h"

namespace dewpoint::simulation {

/// Adds the desk, and pictures on the walls behind it, for Furnishing::Desk.
void furnishDesk(Furniture& room);
/// Adds the objects that lie on this desk in Furnishing::ClutteredDesk.
void clutterDesk(Furniture& room);

} // namespace dewpoint::simulation
