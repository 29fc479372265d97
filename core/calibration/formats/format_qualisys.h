// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// Returns the format of Qualisys Track Manager: .qca.txt, XML with lengths in mm and 1/64 pixels.
CalibrationFormat qualisysFormat();

} // namespace dewpoint::calibration
