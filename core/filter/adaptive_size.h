// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <cstdint>

namespace dewpoint::filter {

/// Returns the number of particles that is needed for a distribution over `occupiedBins` bins. With
/// this number, the Kullback-Leibler distance between the sampled and the true distribution stays
/// below `error` at 99 % confidence. The result is at least 1. Method: KLD-sampling (Fox 2003,
/// equation 13) with the Wilson-Hilferty approximation.
Eigen::Index kldSampleSize(std::int64_t occupiedBins, double error);

/// Returns the number of cubes with edges of `binSize` meters that contain at least one particle.
/// The first three columns of `states` are x, y and z in meters.
std::int64_t countOccupiedBins(const Eigen::ArrayXXd& states, double binSize);

} // namespace dewpoint::filter
