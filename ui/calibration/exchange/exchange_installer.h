// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

struct Workbench;

/// Adds the dialogs that import calibrations from other tools and export calibrations for them.
void installCalibrationExchange(const Workbench& bench);

} // namespace dewpoint::ui
