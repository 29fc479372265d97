// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/doctor/examination.h"

namespace dewpoint::setup {

/// Where the cameras are: guessed, in another unit, of one pose, under the floor, looking away.
void checkCalibration(Examination& examination);

} // namespace dewpoint::setup
