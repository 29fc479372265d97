// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/body/moving_part.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::simulation {

/// The space that the target parts of a body fill together; what several of them share counts once.
/// World frame, meters.
struct TargetVolume {
  double volume = 0.0; ///< cubic meters; 0: no part is marked as target
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< of its points, m²
};

/// Exact where the parts do not overlap. What they share is counted on a grid within each part that
/// moves with it, so that the centroid of a body that moves is smooth in time.
TargetVolume targetVolume(const std::vector<MovingPart>& parts);

} // namespace dewpoint::simulation
