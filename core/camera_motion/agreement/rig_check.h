// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera_motion/agreement/camera_disagreement.h"
#include "core/geometry/camera.h"

#include <vector>

namespace dewpoint::camera_motion {

/// Checks a rig before any images are available. Finds cameras that are farther apart than a room,
/// whose positions must be in another unit, and cameras with the same pose.
std::vector<CameraDisagreement> checkRig(const CameraRig& rig);

/// Returns the likely unit, in meters, of a calibration whose lengths are too large by about this
/// factor: a millimeter, a centimeter or an inch. Returns 0 if the factor is close to none of them.
double unitFromRatio(double ratio);

} // namespace dewpoint::camera_motion
