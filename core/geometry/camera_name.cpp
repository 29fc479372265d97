// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/camera_name.h"

#include <fmt/format.h>

#include <algorithm>

namespace dewpoint::geometry {

std::string defaultCameraName(std::size_t index) {
  return fmt::format("camera {}", index + 1);
}

std::string nameOrNumber(const Camera& camera, std::size_t index) {
  return camera.name.empty() ? defaultCameraName(index) : camera.name;
}

std::string freeCameraName(const CameraRig& rig) {
  std::size_t index = rig.size();
  while (std::ranges::find(rig, defaultCameraName(index), &Camera::name) != rig.end()) {
    ++index;
  }
  return defaultCameraName(index);
}

} // namespace dewpoint::geometry
