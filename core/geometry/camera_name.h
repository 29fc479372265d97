// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <cstddef>
#include <string>

namespace dewpoint::geometry {

/// What a camera is called that nobody has named: "camera 1" for number 0. The one function that
/// decides so for files; the window shows the same words in its language.
std::string defaultCameraName(std::size_t index);

/// The first default name from the rig's size on that no camera of it has.
std::string freeCameraName(const CameraRig& rig);

} // namespace dewpoint::geometry
