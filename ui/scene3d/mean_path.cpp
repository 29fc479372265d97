// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/mean_path.h"

namespace dewpoint::ui {

void MeanPath::add(const TrackSnapshot& snapshot) {
  if (snapshot.isPast || snapshot.rerun || snapshot.iterationCount < iterations_ ||
      snapshot.targets.size() != paths_.size()) {
    paths_.assign(snapshot.targets.size(), {});
  } else if (snapshot.iterationCount == iterations_) {
    return; // the same estimates again
  }
  iterations_ = snapshot.iterationCount;
  for (std::size_t k = 0; k < paths_.size(); ++k) {
    std::vector<Eigen::Vector3d>& path = paths_[k];
    const TrackEstimate& estimate = snapshot.targets[k].estimate;
    const auto position = positionOf(estimate);
    if (isConfirmed(estimate) || !position || !position->mean.allFinite() ||
        particleCountOf(estimate) <= 0) {
      path.clear();
      continue;
    }
    if (path.size() == kMaxPositions) {
      path.erase(path.begin());
    }
    path.push_back(position->mean);
  }
}

const std::vector<Eigen::Vector3d>& MeanPath::positionsOf(std::size_t target) const {
  static const std::vector<Eigen::Vector3d> kNone;
  return target < paths_.size() ? paths_[target] : kNone;
}

} // namespace dewpoint::ui
