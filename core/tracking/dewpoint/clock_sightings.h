// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/dewpoint/clock_estimator.h"
#include "core/tracking/dewpoint/tracked_objects.h"

#include <vector>

namespace dewpoint::tracking {

/// Returns the targets of the frame from which the delays of the cameras can be estimated: those
/// that are tracked as balls and are moving. Fits their outlines in each camera, so the
/// observations must have the images of the frame.
std::vector<ClockEstimator::Sighting> clockSightings(TrackedObjects& objects);

} // namespace dewpoint::tracking
