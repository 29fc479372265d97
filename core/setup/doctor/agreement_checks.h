// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/doctor/examination.h"

namespace dewpoint::setup {

/// Checks whether the images of the first seconds fit the calibration, or show that cameras are
/// exchanged, delayed or moved. Does nothing if another check has found a problem, since it opens
/// the project as a run does.
void checkAgreement(Examination& examination);

} // namespace dewpoint::setup
