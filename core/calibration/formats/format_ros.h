// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// camera_info YAML of ROS, one file per camera, and a file of static transforms beside it.
CalibrationFormat rosFormat();

} // namespace dewpoint::calibration
