// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/trajectory.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::session {
struct TargetSnapshot;
struct TrackSnapshot;
} // namespace dewpoint::session

namespace dewpoint::ui {

/// The speed of the target that is shown, from what was believed in the frames around the one
/// shown, as in the trajectory (trajectory::velocityAt).
class TargetSpeed {
public:
  /// Takes in what is shown of a target; another target or run begins again.
  void add(const TrackSnapshot& snapshot, const TargetSnapshot& target);
  void clear() { track_.clear(); }
  /// At the frame shown last, meters per second; nothing where it is not known.
  std::optional<double> now() const;

private:
  std::vector<TrajectorySample> track_; ///< of the last frames shown, ascending
  std::size_t shown_ = 0;               ///< the sample of the frame shown
  std::string target_;
  std::uint64_t seed_ = 0;
};

} // namespace dewpoint::ui
