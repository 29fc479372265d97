// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/convert_calibration.h"
#include "core/calibration/manual/pose_change.h"
#include "core/project/project.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// The user's statements about a calibration file that is to be taken into a project.
struct ImportRequest {
  std::filesystem::path path; ///< a file, or a folder with a file per camera
  CalibrationHints hints;
  /// Index of the project's camera that a file of one camera is about; nothing: found by name.
  std::optional<std::size_t> camera = {};
};

/// What taking it would change about one camera.
struct ImportedCamera {
  std::size_t camera;   ///< in the project
  std::string name;     ///< in the project
  std::string fileName; ///< in the file
  PoseShift shift;      ///< from the project's present pose
};

/// A calibration file as the project would have it, with all that was decided on the way.
struct CalibrationImport {
  Project project;
  std::string formatTitle;
  std::vector<std::string> decisions; ///< whole sentences: units, axes, directions
  std::vector<ImportedCamera> cameras;
  bool matchedByOrder = false; ///< names fit no camera; the file's order was used
  bool lensOnly = false;       ///< the file has no poses: the project's stay
  /// Difference() between the file's cameras and the project's as saved.
  double largestPixels = 0.0;
};

/// Reads any tool's calibration for a project's cameras, matched by name, else by order when there
/// is one for each camera. The project given is not changed. Errors name file, field and likely
/// cause (readCalibration()).
Result<CalibrationImport> importCalibration(const Project& project, const ImportRequest& request);

/// What a file leaves open, as CalibrationHints has it.
enum class ImportQuestion { None, Format, Unit, Lens, Size, Poses, Camera };

/// The question that an error of importCalibration() raises, and its sentence without the command
/// line's words for the answer.
struct AskedQuestion {
  ImportQuestion question = ImportQuestion::None;
  Error error;
};
AskedQuestion askedQuestion(Error error);

/// Writes the project's cameras in any tool's format.
Result<CalibrationConversion> exportCalibration(const Project& project,
                                                const CalibrationTarget& target);

/// What exportCalibration() would do and lose, without leaving a file; `written` is empty.
Result<CalibrationConversion> previewExport(const Project& project, CalibrationTarget target);

} // namespace dewpoint::setup
