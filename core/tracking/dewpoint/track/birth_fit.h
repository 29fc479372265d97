// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/sphere/sphere_observation.h"
#include "core/tracking/dewpoint/search/candidate_search.h"
#include "core/tracking/dewpoint/track/radius_prior.h"

namespace dewpoint::tracking {

/// The outline at a candidate for a new hypothesis, of the given radius or, where the images
/// contradict it, of theirs (docs/method-dewpoint.md, section 5). `searchSize`: edge of the room,
/// meters. Changes the radius of the observation.
OutlineFit fitBirth(const Candidate& candidate, const RadiusPrior& radius, double searchSize,
                    SphereObservation& observation);

} // namespace dewpoint::tracking
