// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/geometry/camera.h"

#include <filesystem>

namespace dewpoint {

/// Reads a calibration file in the dialect of anipose and Pose2Sim: one table per camera, with the
/// keys of cameraFromToml(); a camera without `name` is called as its table. `[metadata]` is passed
/// over. Metres, unless a camera says `unit`.
Result<CameraRig> loadCalibration(const std::filesystem::path& file);

/// Writes that dialect, in metres: sections [cam_0], [cam_1], ...
Status saveCalibration(const CameraRig& rig, const std::filesystem::path& file);

} // namespace dewpoint
