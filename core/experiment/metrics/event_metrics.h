// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/metrics/proportion.h"
#include "core/experiment/metrics/track_frame.h"
#include "core/trajectory/evaluation.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace dewpoint::experiment {

/// One target at one frame: the input of the metrics of events. World frame, meters.
struct TargetFrame {
  std::int64_t frame = 0;
  std::optional<Eigen::Vector3d> truth;    ///< nothing: the target is not there
  std::optional<Eigen::Vector3d> estimate; ///< nothing: the method does not declare it present
  /// The target can be seen; clear it where no method could (all cameras blind).
  bool visible = true;

  /// Declared present, and nearer to the truth than `gate`.
  bool isFollowed(double gate) const;
};

/// One identity's truth and one identity's estimates, frame by frame, all visible.
std::vector<TargetFrame> targetFrames(std::span<const TrackFrame> frames, int truthIdentity,
                                      int estimateIdentity);

/// Frames before the first of kConvergedRun followed frames in a row (0: from the start); nothing
/// if there is no such run.
std::optional<std::int64_t> framesToConverge(std::span<const TargetFrame> frames, double gate);

/// The same, counted from the frame numbered `event` (a jump, the first frame after a blackout).
std::optional<std::int64_t> framesToReacquire(std::span<const TargetFrame> frames,
                                              std::int64_t event, double gate);

/// Frames from the one numbered `vanished` (the first without the target) in which the method still
/// declares it present; 0: withdrawn at once. Nothing if it was not withdrawn before the target
/// came back or the frames ended.
std::optional<std::int64_t> framesToDeclareLoss(std::span<const TargetFrame> frames,
                                                std::int64_t vanished);

/// Frames with the target there and visible (total), and those of them not followed (count).
Proportion lostFrames(std::span<const TargetFrame> frames, double gate);

/// All frames (total), and those with an estimate that is not nearer than `gate` to any truth
/// (count), such as any estimate while nothing is there.
Proportion falseAlarmFrames(std::span<const TrackFrame> frames, double gate);

} // namespace dewpoint::experiment
