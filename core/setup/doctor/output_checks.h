// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/doctor/examination.h"

namespace dewpoint::setup {

/// Checks whether there is disk space for results in the output folder.
void checkOutput(Examination& examination);

} // namespace dewpoint::setup
