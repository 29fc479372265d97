// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/formats/calibration_format.h"

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Every format known here, ours first.
const std::vector<CalibrationFormat>& calibrationFormats();

/// The format of that name; NotFound lists the names.
Result<const CalibrationFormat*> calibrationFormat(const std::string& name);

/// Which format a text is of, with a sentence why; otherwise what speaks for several, or against
/// all.
struct RecognizedFormat {
  const CalibrationFormat* format = nullptr;
  std::string reason;
};
Result<RecognizedFormat> recognizeFormat(const CalibrationText& source);

} // namespace dewpoint::calibration
