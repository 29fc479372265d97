// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// Returns the format of mrcal: .cameramodel, one file per camera.
CalibrationFormat mrcalFormat();

} // namespace dewpoint::calibration
