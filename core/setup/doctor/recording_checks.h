// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/doctor/examination.h"

namespace dewpoint::setup {

/// Each camera's recording: there, readable, of the right size, complete. Fills in the footage of
/// the cameras.
void checkRecordings(Examination& examination);

} // namespace dewpoint::setup
