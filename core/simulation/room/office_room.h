// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/room/furniture.h"

namespace dewpoint::simulation {

/// Adds desks, cupboards and a partition, for Furnishing::Office.
void furnishOffice(Furniture& room);

} // namespace dewpoint::simulation
