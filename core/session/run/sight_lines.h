// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/snapshot.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::session {

/// The line from a camera to the estimate of a target, meters, world.
struct SightLine {
  int camera = 0; ///< in the order of the rig
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  bool sees =
      true; ///< the camera confirms the target, all of it or a part; else it is hidden there
};

/// One for each camera in whose image the estimate lies; none of a camera without an image, and of
/// targets whose position is not known.
std::vector<SightLine> sightLines(const TrackSnapshot& snapshot, const TargetSnapshot& target);

/// A broken line: `count` strokes from one point to another, with gaps as long as they are.
std::vector<std::vector<Eigen::Vector3d>> dashes(const Eigen::Vector3d& from,
                                                 const Eigen::Vector3d& to, int count);

} // namespace dewpoint::session
