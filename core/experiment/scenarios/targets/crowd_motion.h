// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/scene/stage.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <memory>
#include <vector>

namespace dewpoint::experiment::scenarios {

/// Initial positions (meters) and velocities (m/s) of balls.
struct CrowdStart {
  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Vector3d> velocities; ///< initial velocity of each ball, m/s, one per position
};

/// Motion of equal, weightless balls in a box. The balls bounce elastically off the walls and off
/// each other. The motion is computed once, in 240 steps per second; between steps, the balls move
/// in straight lines.
class CrowdMotion {
public:
  /// Computes the motion for `seconds`. The ball centers stay inside `region`. At the start, they
  /// must be inside `region` and at least two radii apart. Lengths are in meters.
  CrowdMotion(const CrowdStart& start, const Eigen::AlignedBox3d& region, double radius,
              double seconds);

  /// Returns the position of a ball at a time in seconds (world, meters). Before the start, this is
  /// the first position; after the end, it is the last position.
  Eigen::Vector3d position(std::size_t ball, double time) const;

private:
  std::size_t count_ = 0;
  std::vector<Eigen::Vector3d> positions_; ///< [instant * count_ + ball]
};

/// Returns the path of one ball. The path shares ownership of the motion.
simulation::Path pathOf(std::shared_ptr<const CrowdMotion> motion, std::size_t ball);

} // namespace dewpoint::experiment::scenarios
