// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_adaptation.h"
#include "core/calibration/formats/calibration_format.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Destination and format of a calibration that is written.
struct CalibrationOutput {
  std::filesystem::path path; ///< a file, or a folder for formats with one file per camera
  std::string format;         ///< format name; derived from the extension if only one format has it
  /// Meters per unit, for formats that do not define their unit.
  std::optional<double> metersPerUnit;
  bool replacesExisting = false; ///< true to overwrite existing files
};

/// Effect of a conversion on one camera.
struct CameraDifference {
  std::string camera;
  /// True if the lens was fitted again because the format lacks some coefficients.
  bool isRefitted = false;
  double maxDifferencePx = 0.0; ///< largest distance between projections of the same point, pixels
  /// Number of the 9 x 9 compared directions that the written camera cannot see.
  int unseenDirectionCount = 0;
};

/// Decisions made in a conversion, and its accuracy.
struct CalibrationConversion {
  std::string fromFormat;             ///< name of the input format
  std::string toFormat;               ///< name of the output format
  std::vector<std::string> decisions; ///< sentences about decisions made in reading and writing
  std::vector<std::string> notices;   ///< sentences about likely mistakes in the input
  std::vector<CameraDifference> cameraDifferences;
  /// Largest CameraDifference::maxDifferencePx of all cameras, pixels.
  double maxDifferencePx = 0.0;
  std::vector<std::filesystem::path> writtenFiles;
};

/// Returns how far apart two cameras project the same points. The points are at 9 x 9 pixels across
/// the image, at 0.3, 1, 3 and 10 m in front of `camera`. `otherFromWorld` maps the world of
/// `camera` to that of `other`.
CameraDifference compareCameras(const Camera& camera, const Camera& other,
                                const Eigen::Isometry3d& otherFromWorld);

/// Writes a rig (meters) in a format. Lenses that the format cannot represent are fitted again, and
/// the first camera defines the world if the format requires that. The files are then read back,
/// and every camera is compared with the original.
Result<CalibrationConversion> writeCalibration(const CameraRig& rig,
                                               const CalibrationOutput& target);

/// Changes that convertCalibration() makes to the cameras between reading and writing.
struct CalibrationChanges {
  CalibrationAdaptation adaptation;
  /// Image width and height to which `adaptation.sizeFit` adapts the cameras, pixels; not needed
  /// for a rotation.
  std::optional<std::array<int, 2>> imageSize;
};

/// Converts a calibration file to another format. Reads it (readCalibration()), renames the cameras
/// and fits them to another image size if requested, and writes it (writeCalibration()).
Result<CalibrationConversion> convertCalibration(const std::filesystem::path& in,
                                                 const CalibrationHints& hints,
                                                 const CalibrationOutput& target,
                                                 const CalibrationChanges& changes = {});

} // namespace dewpoint::calibration
