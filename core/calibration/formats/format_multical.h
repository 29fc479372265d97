// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// Returns the format of multical: calibration.json; can only be read.
CalibrationFormat multicalFormat();

} // namespace dewpoint::calibration
