// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/doctor/examination.h"

namespace dewpoint::setup {

/// Checks the times of the images: frame rates, tables of times, delays.
void checkTimes(Examination& examination);

} // namespace dewpoint::setup
