// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_format.h"

namespace dewpoint {

/// camera_array.toml of Caliscope: metres.
CalibrationFormat caliscopeFormat();

} // namespace dewpoint
