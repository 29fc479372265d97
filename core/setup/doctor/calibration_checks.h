// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/doctor/examination.h"

namespace dewpoint::setup {

/// Checks the camera poses for problems: poses that are guessed, in another unit, identical, below
/// the floor, or facing away.
void checkCalibration(Examination& examination);

} // namespace dewpoint::setup
