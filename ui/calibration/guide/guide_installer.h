// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

class CalibrationMode;
struct Workbench;

/// Adds the page "Guide" and the strip of steps to the calibration panel. Also asks the user to
/// calibrate while the camera positions are only guesses.
void installCalibrationGuide(const Workbench& bench, CalibrationMode& mode);

} // namespace dewpoint::ui
