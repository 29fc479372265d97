// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <vector>

namespace dewpoint::experiment {

/// Errors (estimate minus truth; world frame, meters) of one target in successive frames. An entry
/// is empty if the target is absent, or if the method does not declare the target present.
using ErrorSequence = std::vector<std::optional<Eigen::Vector3d>>;

/// Returns the jitter: the part of the error that is new in each frame, in meters. This is the root
/// mean square length of the second difference e[k-1] - 2 e[k] + e[k+1], divided by sqrt(6), over
/// all frames k of all sequences in which the three errors exist and are finite. If the errors are
/// independent from frame to frame, the result is the root mean square length of their deviations
/// from the mean error, because the second difference has 1 + 4 + 1 times the variance of one
/// error. A constant or linearly growing error contributes nothing; a jump of the estimate
/// contributes. Returns NaN if there are no three successive errors.
double jitterOf(std::span<const ErrorSequence> sequences);

} // namespace dewpoint::experiment
