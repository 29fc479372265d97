// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/room/furniture.h"

namespace dewpoint::simulation {

/// Furnishing::Desk: the desk, and pictures on the walls behind it.
void furnishDesk(Furniture& room);
/// Furnishing::ClutteredDesk: what lies and stands on that desk besides.
void clutterDesk(Furniture& room);

} // namespace dewpoint::simulation
