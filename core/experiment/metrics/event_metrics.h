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

/// Input of the event metrics for one target in one frame. World frame, meters.
struct TargetFrame {
  std::int64_t frame = 0;
  std::optional<Eigen::Vector3d> truth; ///< true position; empty: the target is absent
  /// Estimated position. Empty: the method does not declare the target present.
  std::optional<Eigen::Vector3d> estimate;
  /// False if no method could see the target, because all cameras are blind in this frame.
  bool isVisible = true;

  /// Returns whether the target is declared present and the distance between its estimate and the
  /// truth is below `gate` (meters).
  bool isFollowed(double gate) const;
};

/// Returns the input of the event metrics for one target, frame by frame: the true position with
/// identity `truthIdentity` and the estimate with identity `estimateIdentity`. All frames are
/// marked as visible.
std::vector<TargetFrame> framesOfTarget(std::span<const TrackFrame> frames, int truthIdentity,
                                        int estimateIdentity);

/// Returns the number of frames until convergence: until the target is followed
/// (TargetFrame::isFollowed()) in kConvergedFrames successive frames. 0 means that the target is
/// followed from the start. Returns nothing if this never happens.
std::optional<std::int64_t> framesToConverge(std::span<const TargetFrame> frames, double gate);

/// Returns the number of frames from frame `event` (a jump, or the first frame after a blackout)
/// until the target is followed again (TargetFrame::isFollowed()) in kConvergedFrames successive
/// frames. Returns nothing if this never happens.
std::optional<std::int64_t> framesToReacquire(std::span<const TargetFrame> frames,
                                              std::int64_t event, double gate);

/// Returns the number of frames, from frame `vanished` on, in which the method still declares a
/// vanished target present. `vanished` is the first frame without the target. 0 means that the
/// method declares the loss immediately. Returns nothing if the method does not declare the loss
/// before the target returns or the frames end.
std::optional<std::int64_t> framesToDeclareLoss(std::span<const TargetFrame> frames,
                                                std::int64_t vanished);

/// Returns the proportion of lost frames: of the frames in which the target is present and visible
/// (total), the number in which it is not followed (count); see TargetFrame::isFollowed().
Proportion lostFrameShare(std::span<const TargetFrame> frames, double gate);

/// Returns the proportion of frames with a false alarm: of all frames (total), the number in which
/// an estimate is at least `gate` (meters) away from every true target (count). In a frame without
/// a target, every estimate is a false alarm.
Proportion falseAlarmFrameShare(std::span<const TrackFrame> frames, double gate);

} // namespace dewpoint::experiment
