// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/tail_pick.h"

namespace dewpoint::ui {

std::optional<TailPosition> nearestTailPosition(const TrackSnapshot& snapshot, const Scene3d& scene,
                                                const Eigen::Vector2d& position, double reach) {
  double nearest = reach;
  std::optional<TailPosition> found;
  for (std::size_t k = 0; k < snapshot.targets.size(); ++k) {
    if (!snapshot.targets[k].target.isShown) {
      continue;
    }
    for (const Eigen::Vector3d& point : snapshot.targets[k].tailPositions) {
      const double away = (scene.projectToImage(point) - position).norm();
      if (away < nearest) {
        nearest = away;
        found = TailPosition{static_cast<int>(k), point};
      }
    }
  }
  return found;
}

} // namespace dewpoint::ui
