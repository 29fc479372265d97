// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/watch/camera_motion_watch.h"

#include <cstdint>
#include <set>
#include <tuple>
#include <vector>

namespace dewpoint::session {

/// Stage of handling a moved camera.
enum class CameraMotionStage {
  Waiting, ///< the camera's new pose is being computed
  Solved,  ///< the camera's new pose is known
  /// The camera's new pose is still unknown after kPoseSearchTimeout, because its images do not
  /// determine the pose.
  Unsolvable,
  Back ///< the camera is back in its calibrated pose
};

/// Time after a camera motion, in seconds of the run, after which a new pose that is still unknown
/// is unlikely to be found.
inline constexpr double kPoseSearchTimeout = 3.0;

/// Returns the stage of handling a moved camera; `now` is in seconds of the run.
CameraMotionStage stageOf(const CameraMotionReport& report, double now);

/// Selects the messages about moved cameras, so that each stage of a motion is reported once. After
/// the new pose is known, no worse stage of the same motion is reported. When a report disappears,
/// the earlier messages are withdrawn and the remaining motions are reported again.
class CameraMotionMessages {
public:
  struct Message {
    CameraMotionReport report;
    CameraMotionStage stage = CameraMotionStage::Waiting;
  };
  struct NewMessages {
    bool withdrawsEarlierMessages = false; ///< earlier messages no longer apply
    std::vector<Message> messages;
  };

  /// Returns the messages that are new in a frame. `reports` are the frame's reports of all moved
  /// cameras, in the order of their motions; `now` is the time in seconds of the run.
  NewMessages update(const std::vector<CameraMotionReport>& reports, double now);
  /// Forgets earlier messages, because another run begins.
  void clear();

private:
  /// Camera, frame of the motion, stage.
  std::set<std::tuple<std::size_t, std::int64_t, CameraMotionStage>> reported_;
  std::size_t count_ = 0; ///< number of reports in the previous call
};

} // namespace dewpoint::session
