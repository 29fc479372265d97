// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/camera_motion_watch.h"

#include <cstdint>
#include <set>
#include <tuple>
#include <vector>

namespace dewpoint::session {

/// The stage of dealing with a camera that was moved.
enum class CameraMotionStage {
  Waiting,    ///< its new pose is being worked out
  Solved,     ///< the new pose is known
  Unsolvable, ///< it is not known after kCameraMotionPatience: what the camera sees does not tell
  Back        ///< it stands again as it was calibrated
};

/// Seconds of the run after which a pose that is still unknown will hardly be found; it is searched
/// for about once a second.
inline constexpr double kCameraMotionPatience = 3.0;

/// `now`: seconds of the run.
CameraMotionStage stageOf(const CameraMotionReport& report, double now);

/// The messages about moved cameras, each stage of a motion once. A pose that is known now and then
/// stays known: nothing worse is said of that motion afterwards. When a motion is dealt with, the
/// others are worth saying again.
class CameraMotionNews {
public:
  struct Item {
    CameraMotionReport report;
    CameraMotionStage stage = CameraMotionStage::Waiting;
  };
  struct News {
    bool withdrawn = false; ///< what was reported before no longer holds
    std::vector<Item> items;
  };

  /// All reports of a frame, in the order of the motions; `now` in seconds of the run.
  News take(const std::vector<CameraMotionReport>& reports, double now);
  /// Another run: earlier messages no longer count.
  void clear();

private:
  std::set<std::tuple<std::size_t, std::int64_t, CameraMotionStage>>
      said_;              ///< camera, frame of the motion
  std::size_t count_ = 0; ///< reports the last time
};

} // namespace dewpoint::session
