// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// Returns the format of anipose and FreeMoCap: TOML, in the unit of the board (usually mm).
CalibrationFormat aniposeFormat();
/// Returns the format of Pose2Sim: TOML with the keys of anipose, four distortion coefficients,
/// meters.
CalibrationFormat pose2simFormat();

} // namespace dewpoint::calibration
