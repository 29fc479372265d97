// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/room/furniture.h"

namespace dewpoint::simulation {

/// Furnishing::Office: adds desks, cupboards and a partition.
void furnishOffice(Furniture& room);

} // namespace dewpoint::simulation
