// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/doctor/examination.h"

namespace dewpoint::setup {

/// Whether there is room for results where they would go.
void checkOutput(Examination& examination);

} // namespace dewpoint::setup
