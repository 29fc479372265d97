// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <cstddef>
#include <functional>
#include <string>

namespace dewpoint::geometry {

/// Returns the default name of an unnamed camera: "camera 1" for index 0. Files always contain this
/// English name, whereas the window shows a translation.
std::string defaultCameraName(std::size_t index);

/// Returns the name of a camera for messages, or its default name if the camera has no name.
std::string nameOrNumber(const Camera& camera, std::size_t index);

/// Returns a default name that no camera of the rig has. Tries defaultCameraName(i) for i =
/// rig.size(), rig.size() + 1, ...
std::string unusedCameraName(const CameraRig& rig);

/// Returns the first name that no camera of the rig has. Tries nameOf(first), nameOf(first + 1),
/// ...
std::string unusedCameraName(const CameraRig& rig, std::size_t first,
                             const std::function<std::string(std::size_t)>& nameOf);

} // namespace dewpoint::geometry
