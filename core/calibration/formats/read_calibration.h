// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

#include <filesystem>

namespace dewpoint::calibration {

/// Reads a calibration of any supported tool: a file, or a folder with one file per camera. The
/// result is in meters, poses camera from world. The format is recognized from the content. What a
/// file does not state (unit, meaning of four coefficients, image size) is never guessed: the error
/// asks for it. Implausible values (a room of 900 m, inverted poses, a principal point outside the
/// image) are an error with the likely cause.
Result<ReadCalibration> readCalibration(const std::filesystem::path& path,
                                        const CalibrationHints& hints = {});

} // namespace dewpoint::calibration
