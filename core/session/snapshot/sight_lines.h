// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/manual/measured_points.h"
#include "core/geometry/projected_lines.h"
#include "core/session/snapshot/snapshot.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::session {

/// Line of sight from a camera to the estimated position of a target, in meters, world frame.
struct SightLine {
  int camera = 0; ///< index of the camera in the rig
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  /// True if the camera confirms at least a part of the target. Otherwise, the target is hidden
  /// from this camera.
  bool seesTarget = true;
};

/// Returns one line of sight for each camera in whose image the estimate lies. Cameras without an
/// image have no line, and there is none if the target's position is unknown.
std::vector<SightLine> sightLines(const TrackSnapshot& snapshot, const TargetSnapshot& target);

/// Returns the line of sight through a clicked pixel as it appears in the image of another camera
/// `camera`, as connected lines in pixels. Empty if the click was made in `camera` itself, or if
/// `camera` is not in the snapshot.
std::vector<ImageLine> clickedRayLines(const TrackSnapshot& snapshot, const PointClick& click,
                                       int camera);

/// Returns the two ends of the line of sight through a clicked pixel, for display, in meters, world
/// frame. The line begins at the camera center and extends 25 % beyond `position`, the position
/// computed from the click. Empty if the camera does not exist.
std::vector<Eigen::Vector3d> clickedRayEnds(const TrackSnapshot& snapshot, const PointClick& click,
                                            const Eigen::Vector3d& position);

/// Returns a dashed line: `count` dashes from one point to another, with gaps of the same length.
std::vector<std::vector<Eigen::Vector3d>> dashedLine(const Eigen::Vector3d& from,
                                                     const Eigen::Vector3d& to, int count);

} // namespace dewpoint::session
