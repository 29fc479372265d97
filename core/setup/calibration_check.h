// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// What a file that was chosen as the calibration of a new project turned out to be.
struct CheckedCalibration {
  std::string formatTitle;          ///< empty: of no format that is known here
  std::vector<std::string> cameras; ///< their names in the file, when it can be used as it is
  std::optional<Error> problem;     ///< why it cannot be used as it is
  bool asks = false; ///< it leaves something open (its unit, say) that importCalibration() is told
};

/// Reads a calibration as makeProject() will. Of a file that cannot be used the format is still
/// recognized where its text allows that.
CheckedCalibration checkCalibration(const std::filesystem::path& file);

/// How makeProject() finds the calibration of each camera in a file.
enum class CameraMatch { ByName, ByOrder, None };
/// `cameras`: of the project; `inFile`: of the file.
CameraMatch matchCameras(const std::vector<std::string>& cameras,
                         const std::vector<std::string>& inFile);

} // namespace dewpoint::setup
