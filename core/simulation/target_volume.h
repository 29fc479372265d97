// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/moving_part.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::simulation {

/// The space that the target parts of a body fill together; what two of them share counts once.
/// World frame, meters.
struct TargetVolume {
  double volume = 0.0; ///< cubic meters; 0: no part is marked as target
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< of its points, m²
};

/// Exact for a single ellipsoid; otherwise the sum over the cells of a grid of kGridCells per side,
/// which leaves less than a fiftieth of a cell in the centroid.
TargetVolume targetVolume(const std::vector<MovingPart>& parts);

/// Cells per side of the grid. A hand of 0.2 m has cells of 7 mm.
inline constexpr int kGridCells = 28;

} // namespace dewpoint::simulation
