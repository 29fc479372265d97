// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

class CalibrationMode;
struct Workbench;

/// Adds wand calibration to the window: its page and its action.
void installWandCalibration(const Workbench& bench, CalibrationMode& mode);

} // namespace dewpoint::ui
