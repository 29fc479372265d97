// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

#include <string>

namespace dewpoint::calibration {

/// Returns the format of this program: the TOML that loadCalibration() reads, meters.
CalibrationFormat dewpointFormat();

/// Returns the text of a calibration file in this program's own format, in meters: sections
/// [cam_0], [cam_1], ...
std::string calibrationText(const CameraRig& rig);

} // namespace dewpoint::calibration
