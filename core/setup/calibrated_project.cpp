// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibrated_project.h"

#include <algorithm>

namespace dewpoint::setup {

Project withCameras(Project project, const CameraRig& rig) {
  for (std::size_t c = 0; c < std::min(rig.size(), project.cameras.size()); ++c) {
    ProjectCamera& camera = project.cameras[c];
    if (camera.camera != rig[c]) {
      camera.markAdjusted();
    }
    camera.camera = rig[c];
  }
  return project;
}

Project withTimeOffsets(Project project, const std::vector<double>& offsets) {
  for (std::size_t c = 0; c < std::min(offsets.size(), project.cameras.size()); ++c) {
    ProjectCamera& camera = project.cameras[c];
    if (camera.source != SourceKind::Simulation) {
      camera.lateBy -= offsets[c];
    }
  }
  return project;
}

Project withIntrinsics(Project project,
                       const std::vector<std::optional<IntrinsicsResult>>& results) {
  for (std::size_t k = 0; k < std::min(results.size(), project.cameras.size()); ++k) {
    if (!results[k]) {
      continue;
    }
    ProjectCamera& of = project.cameras[k];
    of.markAdjusted();
    Camera& camera = of.camera;
    camera.intrinsics = results[k]->camera.intrinsics;
    camera.distortion = results[k]->camera.distortion;
    camera.lens = results[k]->camera.lens;
  }
  return project;
}

} // namespace dewpoint::setup
