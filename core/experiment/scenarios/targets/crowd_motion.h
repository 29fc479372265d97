// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/scene/stage.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <memory>
#include <vector>

namespace dewpoint::experiment::scenarios {

/// Balls at the start of their motion. Meters, m/s.
struct CrowdStart {
  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Vector3d> velocities; ///< as many
};

/// Equal balls without weight that fly in a box and rebound elastically from its walls and from
/// each other, where their centers are two radii apart. Computed once, 240 times a second; between
/// two of these instants they move straight.
class CrowdMotion {
public:
  /// `region` holds the balls' centers; `start` has them in it and no nearer than two radii.
  CrowdMotion(const CrowdStart& start, const Eigen::AlignedBox3d& region, double radius,
              double seconds);

  /// Where a ball is; before the start as at the start, after the end as at the end.
  Eigen::Vector3d position(std::size_t ball, double time) const;

private:
  std::size_t count_ = 0;
  std::vector<Eigen::Vector3d> positions_; ///< [instant * count_ + ball]
};

/// The path of one ball, which keeps the motion alive.
simulation::Path pathOf(std::shared_ptr<const CrowdMotion> motion, std::size_t ball);

} // namespace dewpoint::experiment::scenarios
