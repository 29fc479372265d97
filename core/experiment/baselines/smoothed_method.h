// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/track_estimate.h"

#include <string>
#include <vector>

namespace dewpoint::experiment {

/// The method of the tables that is `dewpoint`, smoothed after the run.
inline constexpr const char* kSmoothedMethod = "dewpoint-smoothed";

/// The estimates of a whole run, by frame and target, as they are known after it (smoother.h).
std::vector<std::vector<SphereEstimate>>
smoothedEstimates(const std::vector<std::vector<SphereEstimate>>& live, double framesPerSecond);

} // namespace dewpoint::experiment
