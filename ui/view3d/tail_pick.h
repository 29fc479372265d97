// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/snapshot.h"
#include "ui/scene3d/scene3d.h"

#include <optional>

namespace dewpoint::ui {

/// Position in the tail of a target, world coordinates in meters.
struct TailPlace {
  int target = -1;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
};

/// Returns the position in any tail that appears nearest to `position` in the picture, within
/// `reach`. Both are in device pixels; `position` is counted to the right of and above the center.
std::optional<TailPlace> nearestInTails(const TrackSnapshot& snapshot, const Scene3d& scene,
                                        const Eigen::Vector2d& position, double reach);

} // namespace dewpoint::ui
