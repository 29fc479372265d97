// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/baselines/rig_start.h"

#include "core/geometry/seen_volume.h"

#include <Eigen/Geometry>

namespace dewpoint::experiment {

std::optional<StartVolume> commonViewVolume(const CameraRig& rig) {
  if (rig.size() < 2) {
    return std::nullopt;
  }
  auto box = geometry::commonVolume(rig, rig.size());
  if (!box) {
    box = geometry::commonVolume(rig, 2);
  }
  return box ? std::optional(StartVolume{box->center(), box->halfSize()}) : std::nullopt;
}

StartVolume startVolumeFromRig(const ScenarioRun& run) {
  const StartVolume given{run.startCenter, run.startHalfSize};
  const auto view = commonViewVolume(run.rig);
  if (!view) {
    return given;
  }
  if (given.halfSize.isZero()) {
    return *view;
  }
  const Eigen::AlignedBox3d common =
      Eigen::AlignedBox3d(given.center - given.halfSize, given.center + given.halfSize)
          .intersection(
              Eigen::AlignedBox3d(view->center - view->halfSize, view->center + view->halfSize));
  return common.isEmpty() ? given : StartVolume{common.center(), 0.5 * common.sizes()};
}

} // namespace dewpoint::experiment
