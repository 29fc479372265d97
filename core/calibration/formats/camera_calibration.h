// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/geometry/camera.h"

#include <toml++/toml.h>

#include <initializer_list>
#include <string>

namespace dewpoint::calibration {

/// Reads one camera from a TOML table with the keys of anipose and Pose2Sim:
/// - `size`: [width, height] (pixels);
/// - `matrix`: 3x3;
/// - `distortions`: 0, 4, 5 or 8 coefficients in OpenCV's order; 4 if `fisheye` = true;
/// - `rotation` (3x3 matrix or Rodrigues vector in radians) and `translation`, both camera from
///   world.
///
/// This program adds the key `unit`, the number of meters in one unit of `translation` (default 1).
/// `name` is optional. Errors name `file`, and `prefix` followed by the key. Examples: a number
/// that is not finite, a focal length that is not positive, a matrix that is not a rotation.
/// Unknown keys are errors, except those in `ignoredKeys`.
Result<Camera> cameraFromToml(const toml::table& table, const std::string& file,
                              const std::string& prefix,
                              std::initializer_list<const char*> ignoredKeys = {});

/// Form in which a rotation is written. A matrix is read back with exactly the same bits. The
/// Rodrigues vector (radians) is the form that other tools read.
enum class RotationForm { Matrix, Vector };

/// Returns a camera as lines of text with the keys of cameraFromToml() and numbers in full
/// precision.
std::string cameraToToml(const Camera& camera, RotationForm form);

} // namespace dewpoint::calibration
