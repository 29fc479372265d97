// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_adaptation.h"
#include "core/calibration/formats/convert_calibration.h"
#include "core/calibration/manual/camera_variation.h"
#include "core/camera_motion/agreement/camera_disagreement.h"
#include "core/project/project.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// The user's information about a calibration file to be imported.
struct ImportRequest {
  std::filesystem::path path; ///< a file, or a folder with one file per camera
  CalibrationHints hints;
  /// Index of the project's camera to which a file with one camera belongs; not set: matched by
  /// name.
  std::optional<std::size_t> camera = {};
  /// How to match cameras if their names in the file differ from those in the project, and how to
  /// adapt the calibration if its image sizes differ.
  CalibrationAdaptation adaptation = {};
};

/// Change of one camera by an import.
struct ImportedCamera {
  std::size_t camera;   ///< camera index in the project
  std::string name;     ///< camera name in the project
  std::string fileName; ///< camera name in the file
  PoseShift poseChange; ///< change from the camera's pose in the project before the import
};

/// Result of importing a calibration file, with all decisions made during the import.
struct CalibrationImport {
  Project project;
  std::string formatTitle;
  std::vector<std::string> decisions; ///< sentences about the decisions: units, axes, directions
  std::vector<ImportedCamera> cameras;
  /// True if no name in the file matched a camera, so that cameras were matched by order.
  bool wereCamerasMatchedByOrder = false;
  /// True if the file has no poses, so that the poses in the project were kept.
  bool hasOnlyIntrinsics = false;
  /// Likely mistakes in the calibration: two cameras with the same pose, or another unit
  /// (checkRig()).
  std::vector<camera_motion::CameraDisagreement> likelyMistakes;
  /// Largest change of a projection, in pixels, if the cameras of the file are saved in Dewpoint's
  /// own format and read again (compareCameras()).
  double maxConversionErrorPx = 0.0;
};

/// Imports the calibration of any supported tool for a project's cameras. Cameras are matched by
/// name, or by order if the file has one for each camera. Returns Mismatch if a calibration is for
/// another image size than that of the recording, unless the request describes how the sizes
/// differ. The given project is not changed. Errors name file, field and likely cause
/// (readCalibration()).
Result<CalibrationImport> importCalibration(const Project& project, const ImportRequest& request);

/// Returns the names of the cameras in the file of a request, in the order of the file. Returns
/// none if the file cannot be read, for example because the request still lacks information.
std::vector<std::string> cameraNamesIn(const ImportRequest& request);

/// Information that an import needs from the user: information that the file lacks (see
/// CalibrationHints), or how to fit the file to the project (see CalibrationAdaptation).
enum class ImportQuestion { None, Format, Unit, Lens, Size, Poses, Camera, Fit, Names };

/// Error of importCalibration(), and the question that it raises. The text of the error does not
/// mention the command-line option that answers the question.
struct ImportProblem {
  ImportQuestion question = ImportQuestion::None;
  Error error;
};
/// Returns the question to ask the user after an error of importCalibration(), so that the import
/// can be repeated with the answer. None if the error raises no question.
ImportProblem importProblem(Error error);

/// Writes the calibration of the project's cameras to a file in the format of any supported tool.
/// `target` describes the file and the format.
Result<CalibrationConversion> exportCalibration(const Project& project,
                                                const CalibrationOutput& target);

/// Returns what exportCalibration() would return, including the information that the export would
/// lose, but creates no file. CalibrationConversion::writtenFiles is empty.
Result<CalibrationConversion> previewExport(const Project& project, CalibrationOutput target);

} // namespace dewpoint::setup
