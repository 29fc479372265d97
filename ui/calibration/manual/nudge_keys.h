// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/calibration/manual_calibration.h"

#include <optional>

class QKeyEvent;

namespace dewpoint::ui {

/// Effect of a key on the selected camera.
struct KeyNudge {
  int axis = 0; ///< 0, 1 or 2: axis along or about which the camera moves; -1: focal length
  double stepsOrPercent = 1.0; ///< number of steps; percent for the focal length
};

/// Returns the effect of a key press, or nothing if the key has no effect. Arrows and W A S D move
/// the camera sideways and forward, or rotate it left, right, up and down. Q, E and the page keys
/// move it down and up, or roll it. Plus and minus change the focal length. Shift multiplies the
/// step by ten. Ctrl divides it by ten, except with letters, because Ctrl with a letter is a window
/// shortcut.
std::optional<KeyNudge> nudgeForKey(const QKeyEvent& event, KeyMode mode);

} // namespace dewpoint::ui
