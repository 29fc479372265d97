// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

#include <array>
#include <cstddef>
#include <vector>

namespace dewpoint::calibration {

/// Largest plausible distance between cameras in a room, in meters. If cameras are farther apart,
/// the rig is assumed to be in another unit than meters. Origin not recorded.
inline constexpr double kMaxCameraSpread = 100.0;

/// Returns the largest distance between two cameras, or of a single camera from the origin, in the
/// rig's unit.
double cameraSpread(const CameraRig& rig);

/// Returns the likely unit of a rig whose cameras are up to `spread` apart (cameraSpread()): "mm"
/// or "m".
const char* likelyUnit(double spread);

/// Returns the pairs of cameras that have the same position and rotation up to rounding, which
/// happens if one camera was copied. (Two separate calibrations of one camera differ by more than
/// rounding.) In each pair, the lower index comes first.
std::vector<std::array<std::size_t, 2>> camerasWithSamePose(const CameraRig& rig);

/// Returns the rig with all poses inverted.
CameraRig withInvertedPoses(CameraRig rig);

/// Checks a rig in meters for implausible properties. Returns an error with the likely cause of the
/// first one found:
/// - a principal point outside the image: matrix and image size are for different resolutions;
/// - cameras more than 100 m or less than 2 cm apart: the lengths are in another unit;
/// - implausible poses whose inverses form a room that all cameras look into: camera-from-world and
///   world-from-camera are exchanged.
///
/// Properties given explicitly in `hints` are not checked.
Status checkPlausibility(const ParsedCalibration& calibration, const CalibrationHints& hints,
                         const std::string& file);

} // namespace dewpoint::calibration
