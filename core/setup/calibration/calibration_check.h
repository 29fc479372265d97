// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// Result of checking a file chosen as the calibration of a new project.
struct CheckedCalibration {
  std::string formatTitle; ///< name of the file format; empty if it is not known
  /// Camera names in the file, if the file can be used without further information.
  std::vector<std::string> cameras;
  std::optional<Error> problem; ///< reason why the file cannot be used without further information
  /// True if the file lacks information, such as its unit, that importCalibration() needs.
  bool needsInput = false;
};

/// Checks a calibration file by reading it in the same way as createNewProject(). If the file
/// cannot be used, its format is still returned, provided that it can be recognized.
CheckedCalibration checkCalibration(const std::filesystem::path& file);

/// Method by which createNewProject() matches the cameras in a file to those of the project.
enum class CameraMatch { ByName, ByOrder, None };
/// Returns how the cameras named `inFile` in a file are matched to those named `cameras` in a
/// project.
CameraMatch matchCameras(const std::vector<std::string>& cameras,
                         const std::vector<std::string>& inFile);

/// Returns the calibration file for recordings that is in the same folder as one of them. The file
/// must be usable without further information, and its cameras must match those named `cameras`.
/// Files that match by name are preferred to files that match by order. Project files are ignored.
/// Returns nothing if there is no such file or more than one. Folders with more than 64 possible
/// calibration files are ignored. May take long, because it reads these files.
std::optional<std::filesystem::path>
calibrationFileBeside(const std::vector<std::string>& recordings,
                      const std::vector<std::string>& cameras);

} // namespace dewpoint::setup
