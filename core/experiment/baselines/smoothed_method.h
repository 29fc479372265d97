// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/track_estimate.h"

#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Table name of the `dewpoint` method with smoothing after the run.
inline constexpr const char* kSmoothedMethod = "dewpoint-smoothed";

/// Smooths the estimates of a whole run, indexed by frame and target (smoother.h).
std::vector<std::vector<SphereEstimate>>
smoothedEstimates(const std::vector<std::vector<SphereEstimate>>& live, double framesPerSecond);

} // namespace dewpoint::experiment
