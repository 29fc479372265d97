// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// camera_array.toml of Caliscope: metres.
CalibrationFormat caliscopeFormat();

} // namespace dewpoint::calibration
