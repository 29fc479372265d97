// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/calibration/manual_calibration.h"

#include <optional>

class QKeyEvent;

namespace dewpoint::ui {

/// What a key does to the chosen camera.
struct KeyNudge {
  int axis = 0;        ///< of ManualCalibration::nudge(); -1: the focal length
  double factor = 1.0; ///< steps; percent for the focal length
};

/// Arrows and W A S D: sideways and forward, or turning left, right, up and down; Q, E and the page
/// keys: down and up, or rolling; plus and minus: the focal length. Shift: ten times as much; Ctrl:
/// a tenth, not with letters, which are the window's then.
std::optional<KeyNudge> nudgeOf(const QKeyEvent& event, KeyMode mode);

} // namespace dewpoint::ui
