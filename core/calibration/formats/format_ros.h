// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// Format of ROS: camera_info YAML, one file per camera, and an additional file of static
/// transforms.
CalibrationFormat rosFormat();

} // namespace dewpoint::calibration
