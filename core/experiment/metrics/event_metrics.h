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

/// One target at one frame: the input of the event metrics. World frame, meters.
struct TargetFrame {
  std::int64_t frame = 0;
  std::optional<Eigen::Vector3d> truth;    ///< nothing: the target is absent
  std::optional<Eigen::Vector3d> estimate; ///< nothing: the method does not declare it present
  /// Whether the target can be seen; false if no method could see it (all cameras blind).
  bool visible = true;

  /// Whether the target is declared present and nearer to the truth than `gate` (meters).
  bool isFollowed(double gate) const;
};

/// Pairs the truth of one identity with the estimates of another, frame by frame, all visible.
std::vector<TargetFrame> targetFrames(std::span<const TrackFrame> frames, int truthIdentity,
                                      int estimateIdentity);

/// Number of frames before the first of kConvergedRun successive followed frames (0: from the
/// start); nothing if there is no such run.
std::optional<std::int64_t> framesToConverge(std::span<const TargetFrame> frames, double gate);

/// The same number, counted from the frame numbered `event` (a jump, the first frame after a
/// blackout).
std::optional<std::int64_t> framesToReacquire(std::span<const TargetFrame> frames,
                                              std::int64_t event, double gate);

/// Number of frames, from the one numbered `vanished` (the first without the target), in which the
/// method still declares the target present; 0: withdrawn at once. Nothing if it was not withdrawn
/// before the target returned or the frames ended.
std::optional<std::int64_t> framesToDeclareLoss(std::span<const TargetFrame> frames,
                                                std::int64_t vanished);

/// Frames in which the target is present and visible (total), and those of them in which it is not
/// followed (count).
Proportion lostFrames(std::span<const TargetFrame> frames, double gate);

/// All frames (total), and those with an estimate that is not nearer than `gate` (meters) to any
/// truth (count). Any estimate counts while no target is present.
Proportion falseAlarmFrames(std::span<const TrackFrame> frames, double gate);

} // namespace dewpoint::experiment
