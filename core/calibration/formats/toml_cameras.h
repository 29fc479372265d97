// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

#include <initializer_list>
#include <string>

namespace dewpoint::calibration {

/// Tools that write one TOML table per camera with the keys of cameraFromToml().
enum class TomlDialect {
  None,
  Dewpoint, ///< `unit` in the metadata or a camera, or none of the marks listed below
  Anipose,  ///< `[metadata]` with `adjusted`
  Pose2Sim  ///< as Anipose, with `fisheye = false` and four coefficients for every camera
};

/// Tool that wrote this text; None if it has no camera table, or is not TOML.
TomlDialect tomlDialect(const CalibrationText& source);

/// Reads every camera table of such a text, without [metadata], in the unit of the file. A camera
/// without `name` has the name of its table. `passedOver` lists keys of other tools that are
/// ignored.
Result<CameraRig> camerasFromToml(const CalibrationText& source,
                                  std::initializer_list<const char*> passedOver);

/// Name of the first camera table with four coefficients and no `fisheye`, so that their meaning is
/// unknown; empty if there is none.
std::string cameraWithUnclearLens(const CalibrationText& source);

} // namespace dewpoint::calibration
