// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <cstddef>
#include <functional>
#include <string>

namespace dewpoint::geometry {

/// Default name of a camera without a name of its own: "camera 1" for index 0. Files always use
/// this function; the window shows the same words in its own language.
std::string defaultCameraName(std::size_t index);

/// What a camera is called in messages: by its name, or by its number where it has none.
std::string nameOrNumber(const Camera& camera, std::size_t index);

/// The first default name from the rig's size on that no camera of it has.
std::string freeCameraName(const CameraRig& rig);

/// The same from number `first` on, with names as `nameOf` gives them to numbers.
std::string freeCameraName(const CameraRig& rig, std::size_t first,
                           const std::function<std::string(std::size_t)>& nameOf);

} // namespace dewpoint::geometry
