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

/// A file and its content.
struct CalibrationText {
  std::filesystem::path file;
  std::string text;
};

/// Hints of the user for what a file does not state.
struct CalibrationHints {
  std::string format;            ///< name of the format; recognized from the content if empty
  std::optional<double> unit;    ///< meters in one unit of the file's lengths
  std::optional<LensModel> lens; ///< lens model of four coefficients
  std::optional<std::array<int, 2>> size; ///< width and height of the images, pixels
  /// Direction of the poses in the file. If it is given, it is not checked.
  std::optional<bool> posesAreWorldFromCamera;
};

/// Cameras read from a file. While `unit` is empty, the lengths of the rig are in the unit of the
/// file.
struct ReadCalibration {
  CameraRig rig;
  std::string format;         ///< name of the format
  std::optional<double> unit; ///< meters in one unit of the lengths, if the file states it
  bool hasPoses = true;       ///< false: intrinsics only, every pose is the identity
  std::vector<std::string>
      decisions; ///< full sentences about units, directions, axes, and what was left out
};

/// Lens models that a format can describe.
struct LensRange {
  int pinholeCoefficients = 8; ///< 4: k1 k2 p1 p2; 5: also k3; 8: also k4 k5 k6
  bool fisheye = false;        ///< also the four coefficients of LensModel::Fisheye
};

/// How a format distributes cameras over files.
enum class FileLayout {
  OneFile,
  FilePerCamera, ///< a folder, or one file for one camera
  CameraPair     ///< intrinsics and extrinsics of two cameras
};

/// File of one camera in FileLayout::FilePerCamera. If `out` is a file name and the rig has one
/// camera, it is `out`; otherwise it is a file in the folder `out` with the name of the camera.
std::filesystem::path cameraFile(const CameraRig& rig, std::size_t camera,
                                 const std::filesystem::path& out, const char* extension);

/// Calibration format of one tool: a row of the catalog (format_catalog.h).
struct CalibrationFormat {
  const char* name = "";      ///< name for the options --from and --to
  const char* title = "";     ///< common name of the format
  const char* extension = ""; ///< extension of written files, with the dot
  const char* holds = "";     ///< content and its form, in one sentence
  FileLayout layout = FileLayout::OneFile;
  LensRange lenses;
  bool sharesKeys =
      false; ///< whether it is one of the TOML dialects that only the user can distinguish
  bool firstCameraIsWorld = false; ///< whether poses are always relative to the first camera
  std::optional<double> unit;      ///< meters in its unit, if its documentation defines it
  double usualUnit = 1.0; ///< unit in which it is written unless another one is requested, meters
  /// Returns the reason why a text is in this format, or an empty text if it is not. Only examines
  /// the text, so that a broken file is still recognized and its own error is reported.
  std::string (*recognize)(const CalibrationText& source) = nullptr;
  Result<ReadCalibration> (*read)(const CalibrationText& source,
                                  const CalibrationHints& hints) = nullptr;
  /// Makes the files for `rig`, which fits `lenses` and is already in the file's unit; null if the
  /// format can only be read.
  std::vector<CalibrationText> (*write)(const CameraRig& rig,
                                        const std::filesystem::path& out) = nullptr;
};

/// Meters in one m, mm, cm, in or ft, or in the unit that a number states in meters; nothing for
/// other texts.
std::optional<double> metersOfUnit(const std::string& text);

} // namespace dewpoint::calibration
