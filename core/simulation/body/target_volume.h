// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/body/moving_part.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::simulation {

/// Volume of those parts of a body that are marked as target. Space where parts overlap counts
/// once. World frame, meters.
struct TargetVolume {
  double volume = 0.0; ///< cubic meters; 0: no part is marked as target
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  /// Covariance of the points in the volume, m².
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// Returns the volume of the parts that are marked as target. The result is exact for parts that do
/// not overlap. Overlaps are evaluated on a grid of points inside each part. The grid moves with
/// the part, so the centroid of a moving body changes smoothly.
TargetVolume targetVolume(const std::vector<MovingPart>& parts);

} // namespace dewpoint::simulation
