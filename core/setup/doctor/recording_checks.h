// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/doctor/examination.h"

namespace dewpoint::setup {

/// Checks that each camera's recording exists, is readable, has the correct size and is complete.
/// Fills in the footage of the cameras.
void checkRecordings(Examination& examination);

} // namespace dewpoint::setup
