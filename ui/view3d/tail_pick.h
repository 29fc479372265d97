// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"
#include "ui/scene3d/scene3d.h"

#include <optional>

namespace dewpoint::ui {

/// Position in a target's tail, meters.
struct TailPosition {
  int target = -1;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/// Returns the position in any tail that appears closest to `position` in the rendered image, or
/// nothing if none is within `reach`. `reach` is in device pixels; `position` is in device pixels
/// to the right of and above the image center.
std::optional<TailPosition> nearestTailPosition(const TrackSnapshot& snapshot, const Scene3d& scene,
                                                const Eigen::Vector2d& position, double reach);

} // namespace dewpoint::ui
