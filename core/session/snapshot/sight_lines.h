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
      /// The camera confirms at least a part of the target; otherwise the target is hidden there.
      true;
};

/// Returns one line for each camera in whose image the estimate lies. Cameras without an image and
/// targets with unknown position have none.
std::vector<SightLine> sightLines(const TrackSnapshot& snapshot, const TargetSnapshot& target);

/// What the image of a camera shows of the ray of a click; nothing in the image of the click
/// itself, and of cameras that the snapshot has not.
std::vector<ImageLine> clickedRay(const TrackSnapshot& snapshot, const PointClick& click,
                                  int camera);

/// The two ends of the ray of a click: its camera, and a quarter farther from it than the position
/// that came of the click, so that the ray is seen to go through that. Empty without a camera.
std::vector<Eigen::Vector3d> clickedSight(const TrackSnapshot& snapshot, const PointClick& click,
                                          const Eigen::Vector3d& position);

/// A broken line: `count` strokes from one point to another, with gaps as long as they are.
std::vector<std::vector<Eigen::Vector3d>> dashes(const Eigen::Vector3d& from,
                                                 const Eigen::Vector3d& to, int count);

} // namespace dewpoint::session
