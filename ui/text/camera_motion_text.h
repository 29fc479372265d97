// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"

#include <QString>

namespace dewpoint::ui {

/// Returns the newest report of a camera that has moved since it was calibrated; null if it has
/// not.
const CameraMotionReport* cameraMotionOf(const TrackSnapshot& snapshot, int camera);
/// Returns how far the camera moved, such as its rotation in degrees; empty for null.
QString cameraMotionText(const CameraMotionReport* report);

} // namespace dewpoint::ui
