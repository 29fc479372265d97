// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera_motion/agreement/camera_disagreement.h"
#include "core/geometry/camera.h"

#include <vector>

namespace dewpoint::camera_motion {

/// What cannot be right of a rig before any image is seen: cameras farther apart than a room, so
/// that their positions are in another unit, and cameras with one pose.
std::vector<CameraDisagreement> checkRig(const CameraRig& rig);

/// The unit of a calibration whose lengths are too large by about this factor: the meters of a
/// millimeter, a centimeter or an inch. 0 where it is near none of them.
double unitOfRatio(double ratio);

} // namespace dewpoint::camera_motion
