// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/world_box.h"
#include "core/observation/region/region_observation.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace dewpoint::tracking {

/// A position at which regions of the color in two or more images may show one object.
struct RegionCandidate {
  Eigen::Vector3d center = Eigen::Vector3d::Zero(); ///< meters, world
  double radius = 0.0;    ///< meters, of a ball as large as what the images show
  double misfit = 0.0;    ///< sum of squared deviations of rays and sizes, in standard deviations
  double logRarity = 0.0; ///< how much rarer regions as large as these are than the smallest
};

/// Searches whole images for an object of any shape: pairs the regions of the target's color
/// between the cameras by their rays and their size. `radius`, in meters, is the size if it is
/// roughly known; 0: it is not. The best candidates, at most `limit`. Makes the labels of the whole
/// images.
std::vector<RegionCandidate> findRegionCandidates(RegionObservation& observation, double radius,
                                                  const std::optional<WorldBox>& bounds,
                                                  std::size_t limit);

} // namespace dewpoint::tracking
