// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/doctor/examination.h"

namespace dewpoint::setup {

/// Whether the first seconds of the images fit the calibration: swapped, late or moved cameras.
/// Only where everything else is right, since it opens the project as a run does.
void checkAgreement(Examination& examination);

} // namespace dewpoint::setup
