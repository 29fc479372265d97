// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

#include <string>

namespace dewpoint::calibration {

/// Our own: the TOML of loadCalibration(), meters.
CalibrationFormat dewpointFormat();

/// The text of such a file, in meters: sections [cam_0], [cam_1], ...
std::string calibrationText(const CameraRig& rig);

} // namespace dewpoint::calibration
