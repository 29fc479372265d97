// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// Format of MC-Calib: calibrated_cameras_data.yml with poses rig from camera.
CalibrationFormat mcCalibFormat();

} // namespace dewpoint::calibration
