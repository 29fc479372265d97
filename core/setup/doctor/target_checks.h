// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/doctor/examination.h"

namespace dewpoint::setup {

/// What is tracked: colors that were never learned, match nothing, or match everything; boxes and
/// radii.
void checkTargets(Examination& examination);

} // namespace dewpoint::setup
