// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

#include <initializer_list>
#include <string>

namespace dewpoint::calibration {

/// The tools that write a TOML table per camera with the keys of cameraFromToml().
enum class TomlDialect {
  None,
  Dewpoint, ///< `unit` in the metadata or a camera, or none of the marks below
  Anipose,  ///< `[metadata]` with `adjusted`
  Pose2Sim  ///< that, with `fisheye = false` and four coefficients for every camera
};

/// Which of them wrote this text; None when it holds no camera table, or is no TOML.
TomlDialect tomlDialect(const CalibrationText& source);

/// Every camera table of such a text but [metadata], in the file's lengths; a camera without `name`
/// is called as its table. `passedOver` are keys of other tools that mean nothing here.
Result<CameraRig> camerasFromToml(const CalibrationText& source,
                                  std::initializer_list<const char*> passedOver);

/// How many coefficients the camera tables list, and whether they say what these mean: the first
/// camera that has four and no `fisheye`, or nothing.
std::string cameraWithUnclearLens(const CalibrationText& source);

} // namespace dewpoint::calibration
