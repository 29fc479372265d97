// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/doctor/examination.h"

namespace dewpoint::setup {

/// Whether the method can work with the project, and what else it is given: the volume of interest,
/// corrections, true positions.
void checkMethod(Examination& examination);

} // namespace dewpoint::setup
