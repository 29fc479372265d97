// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/formats/calibration_format.h"

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Returns all supported formats, starting with this program's own.
const std::vector<CalibrationFormat>& calibrationFormats();

/// Returns the format with this name. Error: NotFound, which lists the valid names.
Result<const CalibrationFormat*> findCalibrationFormat(const std::string& name);

/// Format recognized from the content of a file, with a sentence that gives the reason.
struct RecognizedFormat {
  const CalibrationFormat* format = nullptr;
  std::string reason;
};
/// Recognizes the format of a file from its content. If several formats are possible, or none is,
/// the error explains why.
Result<RecognizedFormat> recognizeFormat(const CalibrationText& source);

} // namespace dewpoint::calibration
