// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/doctor/examination.h"

namespace dewpoint::setup {

/// Checks whether the project's tracking method can work with its cameras and targets. Also checks
/// the method's other inputs: volume of interest, corrections, true positions.
void checkMethod(Examination& examination);

} // namespace dewpoint::setup
