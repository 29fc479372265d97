// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/rig_guidance.h"

#include <algorithm>
#include <set>

namespace dewpoint::calibration {

RigGuidance::RigGuidance(std::vector<int> imageWidths, const Settings& settings)
    : widths_(std::move(imageWidths)), settings_(settings), views_(widths_.size()),
      sharedInstants_(widths_.size() * widths_.size()), last_(widths_.size()) {}

int RigGuidance::sharedInstantCount(int one, int other) const {
  return sharedInstants_[static_cast<std::size_t>(one) * widths_.size() +
                         static_cast<std::size_t>(other)];
}

bool RigGuidance::isStill(double seconds,
                          const std::vector<std::optional<BoardDetection>>& detections) {
  bool still = true;
  for (std::size_t k = 0; k < widths_.size(); ++k) {
    if (detections[k]) {
      const auto moved = last_[k] ? motionBetween(*last_[k], *detections[k]) : std::nullopt;
      const double allowed =
          settings_.maxStillWidthsPerSecond * widths_[k] * (seconds - lastSeconds_);
      still = still && moved && *moved <= allowed;
    }
  }
  last_ = detections;
  lastSeconds_ = seconds;
  return still;
}

bool RigGuidance::isNew(const std::vector<std::optional<BoardDetection>>& detections) const {
  const auto near = [&](std::size_t camera, std::int64_t instant) {
    const auto& views = views_[camera];
    const auto seen = std::ranges::find(views, instant, &BoardView::instant);
    const auto apart =
        seen == views.end() ? std::nullopt : motionBetween(seen->detection, *detections[camera]);
    return apart && *apart < settings_.minDistanceWidths * widths_[camera];
  };
  for (int instant = 0; instant < instants_; ++instant) {
    bool known = true; // to all cameras that see it now, at that one instant
    for (std::size_t k = 0; k < widths_.size(); ++k) {
      known = known && (!detections[k] || near(k, instant));
    }
    if (known) {
      return false;
    }
  }
  return true;
}

void RigGuidance::suggest(State& state) const {
  std::set<int> reached{0};
  const int count = static_cast<int>(widths_.size());
  while (static_cast<int>(reached.size()) < count) {
    int most = -1;
    std::pair<int, int> ends;
    for (const int from : reached) {
      for (int to = 0; to < count; ++to) {
        if (!reached.contains(to) && sharedInstantCount(from, to) > most) {
          most = sharedInstantCount(from, to);
          ends = {from, to};
        }
      }
    }
    if (most < settings_.instantsPerPair) {
      state.firstCamera = ends.first;
      state.secondCamera = ends.second;
      return;
    }
    reached.insert(ends.second);
  }
  state.isFinished = true;
}

bool RigGuidance::areSeenByTwo() const {
  return std::ranges::count_if(last_, [](const auto& d) { return d.has_value(); }) >= 2;
}

void RigGuidance::capture(State& state) {
  for (std::size_t k = 0; k < widths_.size(); ++k) {
    if (!last_[k]) {
      continue;
    }
    views_[k].push_back({"instant " + std::to_string(instants_ + 1), instants_, *last_[k]});
    for (std::size_t other = 0; other < widths_.size(); ++other) {
      sharedInstants_[k * widths_.size() + other] += other != k && last_[other] ? 1 : 0;
    }
  }
  ++instants_;
  stillSince_ = lastSeconds_;
  state.wasCaptured = true;
}

RigGuidance::State RigGuidance::state() const {
  State state;
  state.instantCount = instants_;
  suggest(state);
  return state;
}

RigGuidance::State RigGuidance::captureNow() {
  State taken;
  if (areSeenByTwo()) {
    capture(taken);
  }
  State now = state();
  now.wasCaptured = taken.wasCaptured;
  return now;
}

void RigGuidance::requireMoreInstants(int instants) {
  settings_.instantsPerPair += instants;
}

RigGuidance::State
RigGuidance::update(double seconds, const std::vector<std::optional<BoardDetection>>& detections) {
  State state;
  const bool still = isStill(seconds, detections);
  if (!still || !areSeenByTwo()) {
    stillSince_ = seconds;
  }
  if (areSeenByTwo() && isNew(detections)) {
    state.holdProgress = std::clamp((seconds - stillSince_) / settings_.holdSeconds, 0.0, 1.0);
  }
  if (state.holdProgress >= 1.0) {
    capture(state);
  }
  state.instantCount = instants_;
  suggest(state);
  return state;
}

} // namespace dewpoint::calibration
