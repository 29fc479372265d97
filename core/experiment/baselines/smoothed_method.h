// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/track_estimate.h"

#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Name, in the suite's tables, of the `dewpoint` method with estimates that are smoothed after the
/// run.
inline constexpr const char* kSmoothedMethod = "dewpoint-smoothed";

/// Returns the estimates of a whole run after smoothing (smoother.h). `live` and the result are
/// indexed by frame, then by target.
std::vector<std::vector<SphereEstimate>>
smoothedEstimates(const std::vector<std::vector<SphereEstimate>>& live, double framesPerSecond);

} // namespace dewpoint::experiment
