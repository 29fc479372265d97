// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

#include <filesystem>

namespace dewpoint::calibration {

/// Reads a calibration of any supported tool. `path` is a file, a folder with one file per camera,
/// or a folder with the two files of OpenCV's stereo sample. The result is in meters, with
/// camera-from-world poses. The format is recognized from the content. Information missing from the
/// file (unit, meaning of four coefficients, image size) is never guessed: the error asks the user
/// for it. Implausible values (a room of 900 m, inverted poses, a principal point outside the
/// image) are an error with the likely cause.
Result<ParsedCalibration> readCalibration(const std::filesystem::path& path,
                                          const CalibrationHints& hints = {});

} // namespace dewpoint::calibration
