// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// Format of Qualisys Track Manager: .qca.txt, XML with mm and 1/64 pixels.
CalibrationFormat qualisysFormat();

} // namespace dewpoint::calibration
