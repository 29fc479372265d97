// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/draft/scenario_paths.h"

#include <Eigen/Core>

#include <cstdint>

namespace dewpoint::experiment::scenarios {

/// Closed path with a temporary detour. At `beginTime` (seconds), the ball starts to leave the
/// path; after `reachSeconds`, it has reached the offset `out`. For the next `holdSeconds`, its
/// offset changes to `back`. It then returns to the closed path within `reachSeconds`.
struct Detour {
  LissajousPath basePath;
  /// Offset from the closed path (`basePath`) when the ball has moved aside, meters.
  Eigen::Vector3d out = Eigen::Vector3d::Zero();
  /// Offset from the closed path (`basePath`) when the ball starts to return, meters.
  Eigen::Vector3d back = Eigen::Vector3d::Zero();
  double beginTime = 1.5;
  double reachSeconds = 0.7;
  double holdSeconds = 1.2;

  double holdBeginTime() const { return beginTime + reachSeconds; }
  double holdEndTime() const { return beginTime + reachSeconds + holdSeconds; }
  double endTime() const { return beginTime + 2.0 * reachSeconds + holdSeconds; }
  Eigen::Vector3d operator()(double time) const;
};

/// Visible part of a ball in an image. The rest of the ball is outside the image, or hidden by
/// objects at rest in the room.
enum class Visibility { None, Partial, Full };
/// Returns how much of a ball (world frame, meters) is visible in the image of `view`.
Visibility visibilityOf(const simulation::RoomView& view, const Eigen::Vector3d& center,
                        double radius);

/// Adds an event for each time that the target disappears from a camera's image (UnseenBegin) or
/// appears again (UnseenEnd), according to `isSeen(camera, frame)`. Also adds events for all
/// cameras together (camera -1) where no camera sees the target.
void addInvisibilityEvents(
    ScenarioDraft& draft,
    const std::function<bool(std::size_t camera, std::int64_t frame)>& isSeen);

} // namespace dewpoint::experiment::scenarios
