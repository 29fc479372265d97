// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <cstdint>

namespace dewpoint::filter {

/// Number of particles with which, at 99 % confidence, the Kullback-Leibler distance between the
/// sampled and the true distribution over `occupiedBins` bins stays below `error` (KLD-sampling:
/// Fox 2003, equation 13, with the Wilson-Hilferty approximation). At least 1.
Eigen::Index kldSampleSize(std::int64_t occupiedBins, double error);

/// Number of cubes, with edges of `binSize` meters, that contain at least one particle. The first
/// three columns of `states` are x, y and z in meters.
std::int64_t occupiedBins(const Eigen::ArrayXXd& states, double binSize);

} // namespace dewpoint::filter
