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

/// A file and what stands in it.
struct CalibrationText {
  std::filesystem::path file;
  std::string text;
};

/// The user's hints about a file, for what the file does not state.
struct CalibrationHints {
  std::string format;            ///< name of the format; recognized from the content unless given
  std::optional<double> unit;    ///< meters in one unit of the file's lengths
  std::optional<LensModel> lens; ///< what four coefficients mean
  std::optional<std::array<int, 2>> size; ///< width and height of the images, pixels
  /// Which way the file's poses go; where it is given, it is not checked.
  std::optional<bool> posesAreWorldFromCamera;
};

/// The cameras of a file. While `unit` is empty, the rig's lengths are the file's.
struct ReadCalibration {
  CameraRig rig;
  std::string format;         ///< name of the format
  std::optional<double> unit; ///< meters in one unit of the lengths, as far as the file states it
  bool hasPoses = true;       ///< false: intrinsics only, every pose is the identity
  std::vector<std::string>
      decisions; ///< whole sentences: units, directions, axes, what is left out
};

/// Which lenses a format's coefficients can describe.
struct LensRange {
  int pinholeCoefficients = 8; ///< 4: k1 k2 p1 p2, 5: and k3, 8: and k4 k5 k6
  bool fisheye = false;        ///< also the four of LensModel::Fisheye
};

/// How a format spreads cameras over files.
enum class FileLayout {
  OneFile,
  FilePerCamera, ///< a folder, or one file for one camera
  CameraPair     ///< intrinsics and extrinsics of two cameras
};

/// The file of one camera of a FileLayout::FilePerCamera: `out` itself where that is a file's name
/// and the rig has one camera, else a file in the folder `out` called as the camera.
std::filesystem::path cameraFile(const CameraRig& rig, std::size_t camera,
                                 const std::filesystem::path& out, const char* extension);

/// One tool's calibration files: a row of the catalog (format_catalog.h).
struct CalibrationFormat {
  const char* name = "";      ///< as --from and --to take it
  const char* title = "";     ///< its usual name
  const char* extension = ""; ///< of a file that is written, with its dot
  const char* holds = "";     ///< what it holds, and how, in one sentence
  FileLayout layout = FileLayout::OneFile;
  LensRange lenses;
  bool sharesKeys = false;         ///< one of the TOML dialects that only the user can distinguish
  bool firstCameraIsWorld = false; ///< poses relative to the first camera only
  std::optional<double> unit;      ///< meters in its unit where its documentation fixes it
  double usualUnit = 1.0;          ///< in which it is written unless requested otherwise
  /// Why this text is of this format, or nothing. Looks at the text only, so that a broken file is
  /// still recognized and its own error reported.
  std::string (*recognize)(const CalibrationText& source) = nullptr;
  Result<ReadCalibration> (*read)(const CalibrationText& source,
                                  const CalibrationHints& hints) = nullptr;
  /// The files for `rig`, which fits `lenses` and stands in the file's unit already; nothing where
  /// the format is only read.
  std::vector<CalibrationText> (*write)(const CameraRig& rig,
                                        const std::filesystem::path& out) = nullptr;
};

/// The meters in one m, mm, cm, in or ft, or in as many as a number says; nothing for other texts.
std::optional<double> metersOfUnit(const std::string& text);

} // namespace dewpoint::calibration
