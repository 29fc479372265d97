// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"
#include "ui/scene3d/scene3d.h"

#include <optional>

namespace dewpoint::ui {

/// Position in the tail of a target (its drawn recent path), in meters.
struct TailPosition {
  int target = -1;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/// Returns the point of the targets' tails (their drawn recent paths) whose projection is closest
/// to `position` in the rendered image; nothing if none is closer than `reach`. Both are in device
/// pixels, and `position` is measured to the right of and above the image center.
std::optional<TailPosition> nearestTailPosition(const TrackSnapshot& snapshot, const Scene3d& scene,
                                                const Eigen::Vector2d& position, double reach);

} // namespace dewpoint::ui
