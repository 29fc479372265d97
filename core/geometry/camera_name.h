// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <cstddef>
#include <functional>
#include <string>

namespace dewpoint::geometry {

/// Returns the default name of an unnamed camera: "camera 1" for index 0. Files always use this
/// function. The window shows a translation of the same name.
std::string defaultCameraName(std::size_t index);

/// Returns the camera name used in messages, or the camera number if the camera has no name.
std::string nameOrNumber(const Camera& camera, std::size_t index);

/// Returns the first default name, counting from the rig's size, that no camera of the rig has.
std::string unusedCameraName(const CameraRig& rig);

/// Returns the first unused name, counting from number `first`. `nameOf` returns the name for a
/// number.
std::string unusedCameraName(const CameraRig& rig, std::size_t first,
                             const std::function<std::string(std::size_t)>& nameOf);

} // namespace dewpoint::geometry
