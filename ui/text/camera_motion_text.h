// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/snapshot.h"

#include <QString>

namespace dewpoint::ui {

/// The newest report of a camera that does not stand as it was calibrated; null when it does.
const CameraMotionReport* cameraMotionOf(const TrackSnapshot& snapshot, int camera);
/// "turned by 0.31°"; empty for null.
QString cameraMotionText(const CameraMotionReport* report);

} // namespace dewpoint::ui
