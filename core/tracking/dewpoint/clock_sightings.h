// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/dewpoint/clock_estimator.h"
#include "core/tracking/dewpoint/tracked_objects.h"

#include <vector>

namespace dewpoint::tracking {

/// Returns the targets of the frame that are tracked as balls and are moving. The delays of the
/// cameras can be estimated from these targets. A target that is not almost fully visible has a
/// `weight` of 0. The results point into `objects`.
std::vector<ClockEstimator::Sighting> clockSightings(const TrackedObjects& objects);

} // namespace dewpoint::tracking
