// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/trajectory.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::session {

struct TargetSnapshot;
struct TrackSnapshot;

/// Computes the speed of the displayed target from its estimates in the frames around the displayed
/// frame, in the same way as in trajectories (`trajectory::velocityAt`).
class TargetSpeed {
public:
  /// Adds the estimate of a target in the displayed frame. Starts over when the target or the run
  /// changes.
  void add(const TrackSnapshot& snapshot, const TargetSnapshot& target);
  void clear() { track_.clear(); }
  /// Returns the speed of the target in the frame added last, in meters per second; nothing if
  /// unknown.
  std::optional<double> metersPerSecond() const;

private:
  std::vector<TrajectorySample> track_; ///< samples of the last frames shown, ascending
  std::size_t shown_ = 0;               ///< index of the sample of the frame shown
  std::string target_;
  std::uint64_t seed_ = 0;
};

} // namespace dewpoint::session
