// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// Meters that cameras of one room are apart at most; a wider rig is in another unit. Origin not
/// recorded.
inline constexpr double kWidestRoom = 100.0;

/// The greatest distance between two cameras, or of the only one from the origin, in the rig's
/// unit.
double cameraSpread(const CameraRig& rig);

/// In which unit a room of cameras with such a spread is likely written: "mm" or "m".
const char* likelyUnit(double spread);

/// A rig whose poses all go the other way.
CameraRig withInvertedPoses(CameraRig rig);

/// The first property of a rig in meters that cannot be meant so, as an error with its likely
/// cause:
/// - a principal point outside the image: matrix and size of different resolutions,
/// - cameras more than 100 m, or less than 2 cm apart: another unit,
/// - poses of which the inverse is a room that all cameras look into, while they themselves are
///   none: camera from world mixed up with world from camera.
/// What `hints` say explicitly is not doubted.
Status checkPlausible(const ReadCalibration& calibration, const CalibrationHints& hints,
                      const std::string& file);

} // namespace dewpoint::calibration
