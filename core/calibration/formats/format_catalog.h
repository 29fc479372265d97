// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/formats/calibration_format.h"

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// All supported formats, that of this program first.
const std::vector<CalibrationFormat>& calibrationFormats();

/// Format by name. NotFound lists the names.
Result<const CalibrationFormat*> calibrationFormat(const std::string& name);

/// Recognized format of a text, with a sentence that gives the reason. The error says why the text
/// could be in several formats, or in none.
struct RecognizedFormat {
  const CalibrationFormat* format = nullptr;
  std::string reason;
};
Result<RecognizedFormat> recognizeFormat(const CalibrationText& source);

} // namespace dewpoint::calibration
