// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// calibration.json of multical; only read.
CalibrationFormat multicalFormat();

} // namespace dewpoint::calibration
