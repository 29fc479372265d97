// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// Returns the format of Kalibr: camchain YAML with a chain of poses, meters.
CalibrationFormat kalibrFormat();

} // namespace dewpoint::calibration
