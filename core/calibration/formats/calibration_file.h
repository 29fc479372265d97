// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/geometry/camera.h"

#include <filesystem>

namespace dewpoint::calibration {

/// Reads a calibration file, ours or any other tool's that leaves nothing open (readCalibration()
/// without hints); also a folder with a file per camera. Meters. Files without a pose are an error.
///
/// Ours is TOML in the manner of anipose: one table per camera, with the keys of cameraFromToml();
/// a camera without `name` is called as its table. `[metadata]` is passed over. Meters, unless a
/// camera says `unit`.
Result<CameraRig> loadCalibration(const std::filesystem::path& file);

/// Writes that, in meters: sections [cam_0], [cam_1], ...
Status saveCalibration(const CameraRig& rig, const std::filesystem::path& file);

} // namespace dewpoint::calibration
