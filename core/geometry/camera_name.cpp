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

std::string unusedCameraName(const CameraRig& rig) {
  return unusedCameraName(rig, rig.size(), defaultCameraName);
}

std::string unusedCameraName(const CameraRig& rig, std::size_t first,
                             const std::function<std::string(std::size_t)>& nameOf) {
  std::size_t index = first;
  while (std::ranges::find(rig, nameOf(index), &Camera::name) != rig.end()) {
    ++index;
  }
  return nameOf(index);
}

} // namespace dewpoint::geometry
