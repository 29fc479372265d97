// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/snapshot.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace dewpoint::ui {

/// The way of each cloud's mean through the last snapshots, while its target is not held yet: how
/// the filter comes to its estimate, iteration by iteration.
class MeanPath {
public:
  static constexpr std::size_t kLongest = 60; ///< positions

  /// The next snapshot that came. One of the past, or of a run that began again, begins a new path.
  void add(const TrackSnapshot& snapshot);
  /// World, meters, oldest first; empty for a held target.
  const std::vector<Eigen::Vector3d>& of(std::size_t target) const;

private:
  std::int64_t iterations_ = 0;
  std::vector<std::vector<Eigen::Vector3d>> paths_;
};

} // namespace dewpoint::ui
