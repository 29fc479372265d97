// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/doctor/examination.h"

namespace dewpoint::setup {

/// When the images were taken: rates, tables of times, delays.
void checkTimes(Examination& examination);

} // namespace dewpoint::setup
