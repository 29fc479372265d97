// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

#include <filesystem>

namespace dewpoint::calibration {

/// Reads a calibration of any tool: a file, or a folder with a file per camera. Meters, camera from
/// world. The format is recognized from the content. What a file does not say (unit, meaning of
/// four coefficients, image size) is asked for in the error, never guessed; numbers that cannot be
/// meant so (a room of 900 m, poses the wrong way round, a principal point outside the image) are
/// an error with the likely cause.
Result<ReadCalibration> readCalibration(const std::filesystem::path& path,
                                        const CalibrationHints& hints = {});

} // namespace dewpoint::calibration
