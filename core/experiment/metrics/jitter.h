// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <vector>

namespace dewpoint::experiment {

/// The errors (estimate minus truth; world frame, meters) of one target in successive frames;
/// nothing where there is none, because the target is absent or not declared present.
using ErrorSequence = std::vector<std::optional<Eigen::Vector3d>>;

/// The part of an error that is new in each frame, in meters: the root mean square length of the
/// second difference e[k-1] - 2 e[k] + e[k+1] over all frames k of all sequences for which the
/// three are there and finite, divided by sqrt(6). Of errors that are independent from frame to
/// frame this is the root mean square length of their deviations from the mean error, because the
/// variances of the three add up to 1 + 4 + 1 times that of one. A constant error, and one that
/// grows evenly, have none; a jump of the estimate counts. NaN without three successive errors.
double jitterOf(std::span<const ErrorSequence> sequences);

} // namespace dewpoint::experiment
