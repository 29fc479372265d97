// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/snapshot.h"

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

/// Returns a dashed line of `count` dashes between two points, with gaps as long as the dashes.
std::vector<std::vector<Eigen::Vector3d>> dashes(const Eigen::Vector3d& from,
                                                 const Eigen::Vector3d& to, int count);

} // namespace dewpoint::session
