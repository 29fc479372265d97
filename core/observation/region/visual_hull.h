// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/region/region_measurement.h"
#include "core/observation/region/region_observation.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::observation {

/// The space that the regions of the target's color leave for it: all that lies within them in
/// every camera (Laurentini 1994), or where something may hide it.
struct VisualHull {
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero(); ///< meters, world
  Eigen::Matrix3d extent = Eigen::Matrix3d::Zero(); ///< m²: of an ellipsoid of its second moments
  int samples = 0;                                  ///< that lie in it, of some thousand
};

/// Samples the visual hull around an ellipsoid that is displaced by `velocity` (m/s) times the time
/// of each camera's image. Nothing when fewer than two cameras show a region, or nothing is left.
/// Makes the labels that are needed.
std::optional<VisualHull> visualHull(RegionObservation& observation,
                                     const std::vector<RegionMeasurement>& views,
                                     const Ellipsoid& around, const Eigen::Vector3d& velocity);

} // namespace dewpoint::observation
