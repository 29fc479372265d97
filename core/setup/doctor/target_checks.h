// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/doctor/examination.h"

namespace dewpoint::setup {

/// Checks the targets: colors that were never learned, match nothing, or match everything; boxes
/// and radii.
void checkTargets(Examination& examination);

} // namespace dewpoint::setup
