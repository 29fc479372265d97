// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/camera_motion_watch.h"

#include <cstdint>
#include <set>
#include <tuple>
#include <vector>

namespace dewpoint::session {

/// How far it is with a bumped camera.
enum class CameraMotionStage {
  Waiting,    ///< its new pose is being worked out
  Solved,     ///< the new pose is known
  Unsolvable, ///< it is not known after kCameraMotionPatience: what the camera sees does not tell
  Back        ///< it stands again as it was calibrated
};

/// A pose that is not known then will hardly be (it is looked for about once a second); seconds of
/// the run.
inline constexpr double kCameraMotionPatience = 3.0;

/// `now`: seconds of the run.
CameraMotionStage stageOf(const CameraMotionReport& report, double now);

/// What a person should hear of bumped cameras, each stage of a bump once. A pose that is known now
/// and then stays known: nothing worse is said of that bump afterwards. When a bump is dealt with,
/// the others are worth saying again.
class CameraMotionNews {
public:
  struct Item {
    CameraMotionReport report;
    CameraMotionStage stage = CameraMotionStage::Waiting;
  };
  struct News {
    bool withdrawn = false; ///< what was said before holds no more
    std::vector<Item> items;
  };

  /// All reports of a moment, in the order of the bumps; `now` in seconds of the run.
  News take(const std::vector<CameraMotionReport>& reports, double now);
  /// Another run: what was said counts no more.
  void clear();

private:
  std::set<std::tuple<std::size_t, std::int64_t, CameraMotionStage>>
      said_;              ///< camera, frame of the bump
  std::size_t count_ = 0; ///< reports the last time
};

} // namespace dewpoint::session
