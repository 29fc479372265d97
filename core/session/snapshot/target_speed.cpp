// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/snapshot/target_speed.h"

#include "core/session/snapshot/snapshot.h"
#include "core/trajectory/motion.h"

#include <algorithm>

namespace dewpoint::session {

namespace {
/// Frames that are kept: more than a line is fitted to, so that one can step back a little.
constexpr std::size_t kMaxFrames = 240;
constexpr std::size_t kSpeedReach = 2; ///< frames before and after the one shown
} // namespace

void TargetSpeed::add(const TrackSnapshot& snapshot, const TargetSnapshot& target) {
  const auto position = positionOf(target.estimate);
  const bool isShown = shown_ < track_.size() && track_[shown_].frame == snapshot.frame &&
                       position && track_[shown_].position == position->mean;
  // At the same position in the same frame it is the same target with another name.
  if ((target.target.name != target_ && !isShown) || snapshot.seed != seed_) {
    track_.clear();
    seed_ = snapshot.seed;
  }
  target_ = target.target.name;
  TrajectorySample sample;
  sample.frame = snapshot.frame;
  sample.time = snapshot.frames ? seconds(snapshot.frames->time) : 0.0;
  sample.isValid = position.has_value() && isConfirmed(target.estimate);
  sample.position = position ? position->mean : Eigen::Vector3d::Zero();
  const auto place = std::ranges::lower_bound(track_, sample.frame, {}, &TrajectorySample::frame);
  shown_ = static_cast<std::size_t>(place - track_.begin());
  if (place != track_.end() && place->frame == sample.frame) {
    *place = sample;
    return;
  }
  track_.insert(place, sample);
  if (track_.size() > kMaxFrames) {
    const bool first = shown_ < kMaxFrames / 2; // the farther end goes
    track_.erase(first ? track_.end() - 1 : track_.begin());
    shown_ -= first ? 0 : 1;
  }
}

std::optional<double> TargetSpeed::metersPerSecond() const {
  if (shown_ >= track_.size()) {
    return std::nullopt;
  }
  const std::size_t first = shown_ - std::min(shown_, kSpeedReach);
  const std::size_t last = std::min(track_.size() - 1, shown_ + kSpeedReach);
  std::vector<TrajectorySample> near(track_.begin() + static_cast<std::ptrdiff_t>(first),
                                     track_.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  // Of a run that is faster than the screen not every frame is shown: that is no gap.
  std::int64_t number = 0;
  for (std::size_t k = 0; k < near.size(); ++k) {
    const bool follows = k == 0 || !trajectory::isTrackInterrupted(track_[first + k - 1].frame,
                                                                   track_[first + k].frame);
    number += follows ? 1 : 2;
    near[k].frame = number;
  }
  const auto velocity = trajectory::velocityAt(near, shown_ - first, kSpeedReach);
  return velocity ? std::optional(velocity->norm()) : std::nullopt;
}

} // namespace dewpoint::session
