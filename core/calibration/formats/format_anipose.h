// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// anipose and FreeMoCap: TOML, board units (mostly mm).
CalibrationFormat aniposeFormat();
/// The same keys as Pose2Sim writes them: four coefficients, meters.
CalibrationFormat pose2simFormat();

} // namespace dewpoint::calibration
