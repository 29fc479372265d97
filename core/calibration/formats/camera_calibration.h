// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/geometry/camera.h"

#include <toml++/toml.h>

#include <initializer_list>
#include <string>

namespace dewpoint::calibration {

/// One camera from a TOML table with the keys of anipose and Pose2Sim: `size` = [width, height];
/// `matrix` 3x3; `distortions` (0, 4, 5 or 8 coefficients, OpenCV's order; 4 where
/// `fisheye` = true); `rotation`, a 3x3
/// matrix or a Rodrigues vector (radians), and `translation`, both camera from world; and ours:
/// `unit`, the meters in one unit of `translation` (1 unless given). `name` is taken where present.
/// Errors name `file` and `prefix` + key: not finite, focal length not positive, no rotation, ...
/// Keys of other tools are errors, apart from those in `passedOver`.
Result<Camera> cameraFromToml(const toml::table& table, const std::string& file,
                              const std::string& prefix,
                              std::initializer_list<const char*> passedOver = {});

/// How a rotation is written: the matrix comes back bit by bit, the Rodrigues vector (radians) is
/// what other tools read.
enum class RotationForm { Matrix, Vector };

/// The same keys, as text lines, numbers in full precision.
std::string cameraToToml(const Camera& camera, RotationForm form);

} // namespace dewpoint::calibration
