// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera_motion/agreement/camera_disagreement.h"
#include "core/geometry/camera.h"

#include <vector>

namespace dewpoint::camera_motion {

/// Checks a rig before any image is seen. Finds cameras that are farther apart than a room, so that
/// their positions must be in another unit, and cameras with the same pose.
std::vector<CameraDisagreement> checkRig(const CameraRig& rig);

/// Likely unit of a calibration whose lengths are too large by about this factor, in meters: that
/// of a millimeter, a centimeter or an inch; 0 if the factor is near none of them.
double unitOfRatio(double ratio);

} // namespace dewpoint::camera_motion
