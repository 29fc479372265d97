// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// .cameramodel of mrcal, one file per camera.
CalibrationFormat mrcalFormat();

} // namespace dewpoint::calibration
