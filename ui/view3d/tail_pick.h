// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"
#include "ui/scene3d/scene3d.h"

#include <optional>

namespace dewpoint::ui {

/// A position in the tail of a target, meters.
struct TailPosition {
  int target = -1;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/// The position in any tail that is seen nearest to a position of the picture, within `reach`; all
/// in device pixels right of and above the center.
std::optional<TailPosition> nearestInTails(const TrackSnapshot& snapshot, const Scene3d& scene,
                                           const Eigen::Vector2d& position, double reach);

} // namespace dewpoint::ui
