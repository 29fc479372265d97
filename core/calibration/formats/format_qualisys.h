// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// .qca.txt of Qualisys Track Manager: XML, mm, 1/64 pixels.
CalibrationFormat qualisysFormat();

} // namespace dewpoint::calibration
