// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

class CalibrationMode;
class CameraDocks;
struct Workbench;

/// Adds the page "Floor" to the calibration panel, and the marks that the user places for it to the
/// camera views.
void installWorldPage(const Workbench& bench, CalibrationMode& mode, const CameraDocks& cameras);

} // namespace dewpoint::ui
