// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// Returns the format of ROS: one camera_info YAML file per camera, plus a file with static
/// transforms.
CalibrationFormat rosFormat();

} // namespace dewpoint::calibration
