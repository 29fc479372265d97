// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// Returns the format of Caliscope: camera_array.toml, meters.
CalibrationFormat caliscopeFormat();

} // namespace dewpoint::calibration
