// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <cstddef>
#include <string>

namespace dewpoint::geometry {

/// Default name of a camera without a name of its own: "camera 1" for index 0. Files always use
/// this function; the window shows the same words in its own language.
std::string defaultCameraName(std::size_t index);

/// Returns the first default name, counting from the size of the rig, that no camera of the rig
/// has.
std::string freeCameraName(const CameraRig& rig);

} // namespace dewpoint::geometry
