// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

class CalibrationMode;
class CameraDocks;
struct Workbench;

/// Adds calibration by hand to the window: its page, and the reference grid over the camera views.
void installManualCalibration(const Workbench& bench, CalibrationMode& mode,
                              const CameraDocks& cameras);

} // namespace dewpoint::ui
