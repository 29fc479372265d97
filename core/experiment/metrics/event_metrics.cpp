// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/event_metrics.h"

#include <algorithm>

namespace dewpoint::experiment {
namespace {

std::optional<Eigen::Vector3d> positionOf(const std::vector<TrackPoint>& points, int identity) {
  const auto found = std::find_if(points.begin(), points.end(), [&](const TrackPoint& point) {
    return point.identity == identity;
  });
  return found == points.end() ? std::nullopt : std::optional(found->position);
}

/// The frames from the one numbered `first` on.
std::span<const TargetFrame> startingAt(std::span<const TargetFrame> frames, std::int64_t first) {
  const auto start = std::find_if(frames.begin(), frames.end(),
                                  [&](const TargetFrame& frame) { return frame.frame >= first; });
  return frames.subspan(static_cast<std::size_t>(start - frames.begin()));
}

} // namespace

bool TargetFrame::isFollowed(double gate) const {
  return truth && estimate && (*estimate - *truth).norm() < gate; // false for NaN
}

std::vector<TargetFrame> framesOfTarget(std::span<const TrackFrame> frames, int truthIdentity,
                                        int estimateIdentity) {
  std::vector<TargetFrame> result;
  for (const TrackFrame& frame : frames)
    result.push_back({frame.frame, positionOf(frame.truth, truthIdentity),
                      positionOf(frame.estimates, estimateIdentity), true});
  return result;
}

std::optional<std::int64_t> framesToConverge(std::span<const TargetFrame> frames, double gate) {
  int run = 0;
  std::int64_t seen = 0;
  for (const TargetFrame& frame : frames) {
    ++seen;
    run = frame.isFollowed(gate) ? run + 1 : 0;
    if (run == kConvergedFrames)
      return seen - kConvergedFrames;
  }
  return std::nullopt;
}

std::optional<std::int64_t> framesToReacquire(std::span<const TargetFrame> frames,
                                              std::int64_t event, double gate) {
  return framesToConverge(startingAt(frames, event), gate);
}

std::optional<std::int64_t> framesToDeclareLoss(std::span<const TargetFrame> frames,
                                                std::int64_t vanished) {
  std::int64_t declared = 0;
  for (const TargetFrame& frame : startingAt(frames, vanished)) {
    if (frame.truth)
      return std::nullopt;
    if (!frame.estimate)
      return declared;
    ++declared;
  }
  return std::nullopt;
}

Proportion lostFrameShare(std::span<const TargetFrame> frames, double gate) {
  Proportion lost;
  for (const TargetFrame& frame : frames) {
    if (!frame.truth || !frame.isVisible)
      continue;
    ++lost.total;
    lost.count += frame.isFollowed(gate) ? 0 : 1;
  }
  return lost;
}

Proportion falseAlarmFrameShare(std::span<const TrackFrame> frames, double gate) {
  Proportion alarms;
  for (const TrackFrame& frame : frames) {
    const Eigen::MatrixXd distance = distances(frame);
    bool alarm = false;
    for (Eigen::Index column = 0; column < distance.cols(); ++column)
      alarm = alarm || !(distance.col(column).array() < gate).any();
    ++alarms.total;
    alarms.count += alarm ? 1 : 0;
  }
  return alarms;
}

} // namespace dewpoint::experiment
