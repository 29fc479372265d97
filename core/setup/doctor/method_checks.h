// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/doctor/examination.h"

namespace dewpoint::setup {

/// Checks whether the method can work with the project, and checks its other inputs: volume of
/// interest, corrections, true positions.
void checkMethod(Examination& examination);

} // namespace dewpoint::setup
