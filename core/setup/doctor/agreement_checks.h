// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/doctor/examination.h"

namespace dewpoint::setup {

/// Checks whether the first seconds of the images fit the calibration: exchanged, delayed or moved
/// cameras. Runs only if everything else is correct, since it opens the project as a run does.
void checkAgreement(Examination& examination);

} // namespace dewpoint::setup
