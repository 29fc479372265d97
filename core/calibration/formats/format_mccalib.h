// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// Returns the format of MC-Calib: calibrated_cameras_data.yml with rig-from-camera poses.
CalibrationFormat mcCalibFormat();

} // namespace dewpoint::calibration
