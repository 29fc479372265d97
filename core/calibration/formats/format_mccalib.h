// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// calibrated_cameras_data.yml of MC-Calib: poses are rig from camera.
CalibrationFormat mcCalibFormat();

} // namespace dewpoint::calibration
