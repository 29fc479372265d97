// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_format.h"

namespace dewpoint {

/// calibration.json of multical; only read.
CalibrationFormat multicalFormat();

} // namespace dewpoint
