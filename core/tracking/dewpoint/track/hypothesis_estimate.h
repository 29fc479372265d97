// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/dewpoint/search/search_particles.h"
#include "core/tracking/dewpoint/track/systematic_errors.h"
#include "core/tracking/dewpoint/track/track_hypothesis.h"
#include "core/tracking/track_estimate.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::tracking {

/// The estimate of a target from its likeliest hypothesis, which has particles. Its mean is that of
/// the particles, its covariance that of the hypothesis' Gaussian and of the `errors`.
///
/// `existenceProbability` is the probability that the target is at the estimate: the hypothesis'
/// probability, times 1 - `identityAmbiguity` (0 to 1, probability that the hypothesis is an
/// identical object), times, while no camera sees the target, the probability that it is within its
/// radius of the estimate. `valid`: likelier than not there, the identity left aside, and known
/// well enough to be of use. Sets the radius of the observation.
SphereEstimate sphereEstimateFrom(const TrackHypothesis& hypothesis, double identityAmbiguity,
                                  const SystematicErrors& errors, SphereObservation& observation);

/// The same without what the cameras show: `seeingCenters` are the optical centers of those that
/// see the target (meters, world), and `ofShape` (m²) is a systematic error more.
SphereEstimate estimateFrom(const TrackHypothesis& hypothesis, double identityAmbiguity,
                            const std::vector<Eigen::Vector3d>& seeingCenters,
                            const SystematicErrors& errors, const Eigen::Matrix3d& ofShape);

/// The estimate of a target that is searched for: moments of the particles; not valid.
SphereEstimate sphereEstimateFrom(const SearchParticles& particles);

} // namespace dewpoint::tracking
