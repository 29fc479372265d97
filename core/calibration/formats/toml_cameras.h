// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

#include <initializer_list>
#include <string>

namespace dewpoint::calibration {

/// Tools that write one TOML table per camera with the keys of cameraFromToml().
enum class TomlDialect {
  None,
  /// The file has `unit` in its metadata or in a camera, or none of the features of the other
  /// dialects.
  Dewpoint,
  Anipose, ///< the file has `adjusted` in its `[metadata]`
  /// The file has the features of Anipose, and `fisheye = false` and four coefficients for every
  /// camera.
  Pose2Sim
};

/// Returns the tool that wrote a file; None if the file has no camera table or is not TOML.
TomlDialect recognizeTomlDialect(const CalibrationText& source);

/// Reads every camera table in a file, except [metadata], in the unit of the file. A camera without
/// `name` is named after its table. `ignoredKeys` lists keys from other tools that are ignored.
Result<CameraRig> camerasFromToml(const CalibrationText& source,
                                  std::initializer_list<const char*> ignoredKeys);

/// Returns the name of the first camera table with four coefficients but without the key `fisheye`.
/// The lens model of such a camera is not clear. Empty if there is no such table.
std::string cameraWithUnclearLens(const CalibrationText& source);

} // namespace dewpoint::calibration
