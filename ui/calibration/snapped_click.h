// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"

#include <Eigen/Core>

namespace dewpoint::ui {

/// Returns the image pixel to which a click in a camera image snaps: the closest corner, refined to
/// a fraction of a pixel. Returns the clicked pixel itself if `exact` is true, if the snapshot has
/// no image of this camera, or if no corner is near.
Eigen::Vector2d snappedClick(const TrackSnapshotPtr& snapshot, int camera,
                             const Eigen::Vector2d& pixel, bool exact);

} // namespace dewpoint::ui
