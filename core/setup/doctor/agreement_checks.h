// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/doctor/examination.h"

namespace dewpoint::setup {

/// Checks whether the images of the first seconds fit the calibration, or show that cameras are
/// exchanged, delayed or moved. It opens the images as a run would, so it does nothing if another
/// check has found a problem.
void checkAgreement(Examination& examination);

} // namespace dewpoint::setup
