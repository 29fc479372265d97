// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// Our own: the TOML of loadCalibration(), meters.
CalibrationFormat dewpointFormat();

} // namespace dewpoint::calibration
