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
  bool sees =
      /// True if the camera confirms at least a part of the target; otherwise, the target is hidden
      /// there.
      true;
};

/// Returns one line for each camera in whose image the estimate lies. There is no line for a camera
/// without an image or a target with an unknown position.
std::vector<SightLine> sightLines(const TrackSnapshot& snapshot, const TargetSnapshot& target);

/// Returns the part of a click's ray that is visible in the image of a camera, as lines. Returns
/// none for the camera that was clicked in and for cameras not in the snapshot.
std::vector<ImageLine> clickedRay(const TrackSnapshot& snapshot, const PointClick& click,
                                  int camera);

/// Returns both ends of a click's ray: the camera, and a point a quarter farther away than the
/// position computed from the click, so that the ray visibly passes through this position. Empty if
/// the camera does not exist.
std::vector<Eigen::Vector3d> clickedRayEnds(const TrackSnapshot& snapshot, const PointClick& click,
                                            const Eigen::Vector3d& position);

/// Returns a dashed line: `count` dashes from one point to another, with gaps of the same length.
std::vector<std::vector<Eigen::Vector3d>> dashes(const Eigen::Vector3d& from,
                                                 const Eigen::Vector3d& to, int count);

} // namespace dewpoint::session
