// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/scene/stage.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <memory>
#include <vector>

namespace dewpoint::experiment::scenarios {

/// Positions and velocities of balls at the start. Meters, m/s.
struct CrowdStart {
  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Vector3d> velocities; ///< one per position
};

/// Motion of equal, weightless balls that fly in a box and rebound elastically from its walls and
/// from each other, when their centers are two radii apart. It is computed once, 240 times per
/// second; between these instants the balls move straight.
class CrowdMotion {
public:
  /// `region` bounds the centers of the balls; in `start` they are inside it and at least two radii
  /// apart.
  CrowdMotion(const CrowdStart& start, const Eigen::AlignedBox3d& region, double radius,
              double seconds);

  /// Position of a ball. Before the start it is the first position, after the end the last.
  Eigen::Vector3d position(std::size_t ball, double time) const;

private:
  std::size_t count_ = 0;
  std::vector<Eigen::Vector3d> positions_; ///< [instant * count_ + ball]
};

/// Path of one ball; it shares ownership of the motion.
simulation::Path pathOf(std::shared_ptr<const CrowdMotion> motion, std::size_t ball);

} // namespace dewpoint::experiment::scenarios
