// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

class CalibrationMode;
class CameraDocks;
struct Workbench;

/// Adds board calibration to the window: its page, its actions, and outlines of detected boards
/// over the camera views.
void installBoardCalibration(const Workbench& bench, CalibrationMode& mode,
                             const CameraDocks& cameras);

} // namespace dewpoint::ui
