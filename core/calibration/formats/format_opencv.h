// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// What the calibration sample of OpenCV writes: one camera, FileStorage YAML.
CalibrationFormat opencvFormat();
/// What the stereo sample writes: intrinsics.yml (M1 D1 M2 D2) and extrinsics.yml (R T ...).
CalibrationFormat opencvStereoFormat();

} // namespace dewpoint::calibration
