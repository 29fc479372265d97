// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/geometry/camera.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Path of a file, and the content of this file.
struct CalibrationText {
  std::filesystem::path file;
  std::string text;
};

/// Hints from the user about information that is missing from a file.
struct CalibrationHints {
  std::string format;                  ///< format name; recognized from the content if empty
  std::optional<double> metersPerUnit; ///< meters per unit of length in the file
  std::optional<LensModel> lens;       ///< lens model of cameras with four coefficients
  std::optional<std::array<int, 2>> imageSize; ///< image width and height, pixels
  /// True if the poses in the file are world-from-camera, false if they are camera-from-world. If
  /// specified, the plausibility of the poses is not checked.
  std::optional<bool> posesAreWorldFromCamera;
};

/// Cameras read from a file. If `metersPerUnit` is empty, the lengths of the rig are in the unit of
/// the file.
struct ParsedCalibration {
  CameraRig rig;
  std::string format;                  ///< format name
  std::optional<double> metersPerUnit; ///< meters per unit of length, if specified in the file
  bool hasPoses = true;                ///< false: intrinsics only, and every pose is the identity
  /// Complete sentences about how units, directions and axes were interpreted, and which data was
  /// omitted.
  std::vector<std::string> decisions;
};

/// Lens models that a format can represent.
struct LensSupport {
  int pinholeCoefficientCount = 8; ///< how many: 4 (k1 k2 p1 p2), 5 (also k3) or 8 (also k4 k5 k6)
  /// True if the format also has the four coefficients of LensModel::Fisheye.
  bool supportsFisheye = false;
};

/// Distribution of cameras among the files of a format.
enum class FileLayout {
  OneFile,
  FilePerCamera, ///< a folder, or one file for one camera
  /// Two files for exactly two cameras: one with the intrinsics, one with the extrinsics.
  CameraPair
};

/// Returns the path of the file for one camera in FileLayout::FilePerCamera. If `out` is a file
/// name and the rig has only one camera, this is `out`. Otherwise it is a file in the folder `out`,
/// named after the camera.
std::filesystem::path cameraFile(const CameraRig& rig, std::size_t camera,
                                 const std::filesystem::path& out, const char* extension);

/// Calibration format of a tool: one row of the catalog (format_catalog.h).
struct CalibrationFormat {
  const char* name = "";      ///< name used with the options --from and --to
  const char* title = "";     ///< commonly used name of the format
  const char* extension = ""; ///< extension of written files, including the dot
  /// Further extensions of files in this format, including the dots.
  std::vector<const char*> otherExtensions = {};
  const char* description = ""; ///< content and structure, in one sentence
  FileLayout layout = FileLayout::OneFile;
  LensSupport lensSupport;
  /// True for a TOML dialect whose files can look exactly like those of another dialect. Only the
  /// user then knows which tool wrote a file.
  bool looksLikeOtherDialect = false;
  /// True if recognize() may also accept files of other formats. If another format also recognizes
  /// a file, the other format is used.
  bool isFallback = false;
  bool firstCameraIsWorld = false; ///< true if poses are always relative to the first camera
  /// Meters per unit, if defined by the format's documentation.
  std::optional<double> metersPerUnit;
  /// Unit used for writing unless another one is requested, meters.
  double defaultMetersPerUnit = 1.0;
  /// Returns the reason why the content of a file seems to be in this format, or an empty string if
  /// it does not. Only examines the text, so that a broken file is still recognized and its own
  /// error is reported.
  std::string (*recognize)(const CalibrationText& source) = nullptr;
  Result<ParsedCalibration> (*read)(const CalibrationText& source,
                                    const CalibrationHints& hints) = nullptr;
  /// Returns the paths and contents of the files for `rig`, without writing them to disk. The
  /// lenses of `rig` must fit `lensSupport`, and its lengths must already be in the unit of the
  /// files. Null if the format can only be read.
  std::vector<CalibrationText> (*write)(const CameraRig& rig,
                                        const std::filesystem::path& out) = nullptr;
};

/// Returns the size of a length unit in meters. The text is m, mm, cm, in, ft, or a positive number
/// of meters. Returns nothing for any other text.
std::optional<double> parseLengthUnit(const std::string& text);
/// Returns what was expected instead of a text that parseLengthUnit() does not accept; empty if it
/// accepts the text.
std::string lengthUnitProblem(const std::string& text);

} // namespace dewpoint::calibration
