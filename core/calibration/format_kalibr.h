// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_format.h"

namespace dewpoint {

/// camchain YAML of Kalibr: a chain of poses, metres.
CalibrationFormat kalibrFormat();

} // namespace dewpoint
