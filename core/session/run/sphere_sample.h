// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/track_estimate.h"
#include "core/trajectory/trajectory.h"

#include <cstdint>
#include <string>

namespace dewpoint::session {

/// Returns the estimate of a colored target as a row of a trajectory; `time` in seconds. Does not
/// set whether the user corrected the estimate; the caller must set this.
TrajectorySample sampleOf(const SphereEstimate& sphere, const std::string& target,
                          std::int64_t frame, double time);

} // namespace dewpoint::session
