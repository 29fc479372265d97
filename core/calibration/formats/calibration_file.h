// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/geometry/camera.h"

#include <filesystem>

namespace dewpoint::calibration {

/// Reads a calibration file written by this program or any other tool. Uses readCalibration()
/// without hints from the user, so a file that lacks information is an error. Also reads a folder
/// with one file per camera. The result is in meters. Files without poses are an error.
///
/// The format of this program is TOML in the style of anipose: one table per camera, with the keys
/// of cameraFromToml(). A camera without `name` is named after its table. `[metadata]` is ignored.
/// Lengths are in meters unless a camera specifies a `unit`.
Result<CameraRig> loadCalibration(const std::filesystem::path& file);

/// Writes a calibration in this program's format, in meters: sections [cam_0], [cam_1], ...
Status saveCalibration(const CameraRig& rig, const std::filesystem::path& file);

} // namespace dewpoint::calibration
