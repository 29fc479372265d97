// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/world_box.h"
#include "core/observation/region/region_observation.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace dewpoint::tracking {

/// Position at which color regions in two or more images may show the same object.
struct RegionCandidate {
  Eigen::Vector3d center = Eigen::Vector3d::Zero(); ///< meters, world frame
  double radius = 0.0; ///< radius in meters of a ball that is as large as the regions in the images
  double misfit = 0.0; ///< sum of squared deviations of rays and sizes, in standard deviations
  /// Logarithm of the factor by which regions of this size are rarer than regions of the smallest
  /// size.
  double logRarity = 0.0;
};

/// Searches whole images for an object of any shape and returns at most `limit` candidates, best
/// first. Method: pair the regions of the target's color between cameras by their rays and sizes.
/// `radius` is the approximate size in meters, or 0 if it is unknown. Afterward, every pixel of the
/// images has a label that tells whether it has the target's color.
std::vector<RegionCandidate> findRegionCandidates(RegionObservation& observation, double radius,
                                                  const std::optional<WorldBox>& bounds,
                                                  std::size_t limit);

} // namespace dewpoint::tracking
