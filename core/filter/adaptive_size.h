// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <cstdint>

namespace dewpoint::filter {

/// Particles needed so that, with 99 % confidence, the Kullback-Leibler distance between the
/// sampled and the true distribution over `occupiedBins` bins stays below `error` (KLD-sampling:
/// Fox 2003, equation 13, by the Wilson-Hilferty approximation). At least 1.
Eigen::Index kldSampleSize(std::int64_t occupiedBins, double error);

/// Number of cubes with edges of `binSize` meters that the first three columns of `states` (x, y,
/// z) fall into.
std::int64_t occupiedBins(const Eigen::ArrayXXd& states, double binSize);

} // namespace dewpoint::filter
