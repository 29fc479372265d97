// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace dewpoint::ui {

/// Path of the mean of each particle cloud over the last snapshots, while the cameras have not yet
/// confirmed the cloud's target. The path shows how the filter converges, iteration by iteration.
class MeanPath {
public:
  static constexpr std::size_t kMaxPositions = 60; ///< maximum number of positions in a path

  /// Adds the next snapshot. A snapshot of a past frame, or of a restarted run, starts a new path.
  void add(const TrackSnapshot& snapshot);
  /// Returns a target's path in world coordinates (meters), oldest first; empty for a target
  /// that the cameras confirm.
  const std::vector<Eigen::Vector3d>& positionsOf(std::size_t target) const;

private:
  std::int64_t iterations_ = 0;
  std::vector<std::vector<Eigen::Vector3d>> paths_;
};

} // namespace dewpoint::ui
