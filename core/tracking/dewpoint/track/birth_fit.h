// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/sphere/sphere_observation.h"
#include "core/tracking/dewpoint/search/candidate_search.h"
#include "core/tracking/dewpoint/track/radius_prior.h"

namespace dewpoint::tracking {

/// Fits the outline of the target at a candidate for a new hypothesis. The radius is the given
/// radius. If the images contradict the given radius, the radius is measured in the images
/// (docs/method-dewpoint.md, section 5). `searchCubeEdge` is the edge length of the room in meters.
/// Changes the radius of the observation.
OutlineFit fitCandidateOutline(const Candidate& candidate, const RadiusPrior& radius,
                               double searchCubeEdge, SphereObservation& observation);

} // namespace dewpoint::tracking
