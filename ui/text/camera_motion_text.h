// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"

#include <QString>

namespace dewpoint::ui {

/// Returns the newest report of a camera that has moved since it was calibrated, or null if it has
/// not moved.
const CameraMotionReport* cameraMotionOf(const TrackSnapshot& snapshot, int camera);
/// Returns how far the camera moved, for example its rotation in degrees. Returns an empty string
/// if `report` is null.
QString cameraMotionText(const CameraMotionReport* report);

} // namespace dewpoint::ui
