// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_rig.h"

#include <algorithm>

namespace dewpoint::project {

CameraRig rigOf(const Project& project) {
  CameraRig rig;
  rig.reserve(project.cameras.size());
  for (const auto& camera : project.cameras) {
    rig.push_back(camera.camera);
  }
  return rig;
}

bool haveSameImageSizes(const CameraRig& a, const CameraRig& b) {
  return std::ranges::equal(a, b, [](const Camera& first, const Camera& second) {
    return first.intrinsics.width == second.intrinsics.width &&
           first.intrinsics.height == second.intrinsics.height;
  });
}

} // namespace dewpoint::project
