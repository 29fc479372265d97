// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/manual/measured_points.h"
#include "core/geometry/projected_lines.h"
#include "core/session/snapshot/snapshot.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::session {

/// Line from a camera to the estimate of a target, in meters, world frame.
struct SightLine {
  int camera = 0; ///< index in the rig
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  /// True if the camera confirms at least a part of the target. Otherwise, the target is hidden
  /// there.
  bool sees = true;
};

/// Returns one line for each camera in whose image the estimate lies. There is no line for a camera
/// without an image or a target with an unknown position.
std::vector<SightLine> sightLines(const TrackSnapshot& snapshot, const TargetSnapshot& target);

/// Returns the line of sight through a clicked pixel as it appears in the image of another camera,
/// as connected lines in pixels. Returns none if `camera` is the one that was clicked in, or is not
/// in the snapshot.
std::vector<ImageLine> clickedRay(const TrackSnapshot& snapshot, const PointClick& click,
                                  int camera);

/// Returns the two ends of the line of sight through a clicked pixel, for display. One end is the
/// camera center. The other is 25 % farther away than `position`, the position computed from the
/// click, so that the line visibly passes through this position. Empty if the camera does not
/// exist.
std::vector<Eigen::Vector3d> clickedRayEnds(const TrackSnapshot& snapshot, const PointClick& click,
                                            const Eigen::Vector3d& position);

/// Returns a dashed line: `count` dashes from one point to another, with gaps of the same length.
std::vector<std::vector<Eigen::Vector3d>> dashes(const Eigen::Vector3d& from,
                                                 const Eigen::Vector3d& to, int count);

} // namespace dewpoint::session
