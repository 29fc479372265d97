// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// Returns the format of OpenCV's calibration sample: one camera, FileStorage YAML.
CalibrationFormat opencvFormat();
/// Returns the format of OpenCV's stereo sample: intrinsics.yml (M1 D1 M2 D2) and extrinsics.yml (R
/// T ...).
CalibrationFormat opencvStereoFormat();

} // namespace dewpoint::calibration
