// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/track_estimate.h"

#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Name, in the tables, of method `dewpoint` smoothed after the run.
inline constexpr const char* kSmoothedMethod = "dewpoint-smoothed";

/// Estimates of a whole run, by frame and target, smoothed after the run (smoother.h).
std::vector<std::vector<SphereEstimate>>
smoothedEstimates(const std::vector<std::vector<SphereEstimate>>& live, double framesPerSecond);

} // namespace dewpoint::experiment
