// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

#include <filesystem>

namespace dewpoint::calibration {

/// Reads a calibration of any tool: a file, or a folder with a file per camera. Meters, camera from
/// world. The format is recognized from the content. What a file does not state (unit, meaning of
/// four coefficients, image size) is never guessed: the error requests it. Implausible numbers (a
/// room of 900 m, poses the wrong way round, a principal point outside the image) are an error with
/// the likely cause.
Result<ReadCalibration> readCalibration(const std::filesystem::path& path,
                                        const CalibrationHints& hints = {});

} // namespace dewpoint::calibration
