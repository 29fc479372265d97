// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_format.h"

namespace dewpoint {

/// Our own: the TOML of loadCalibration(), metres.
CalibrationFormat dewpointFormat();

} // namespace dewpoint
