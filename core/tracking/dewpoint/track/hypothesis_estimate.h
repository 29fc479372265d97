// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/dewpoint/search/search_particles.h"
#include "core/tracking/dewpoint/track/systematic_errors.h"
#include "core/tracking/dewpoint/track/track_hypothesis.h"
#include "core/tracking/track_estimate.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::tracking {

/// Returns the estimate of a target from its most likely hypothesis, which must have particles. The
/// mean is the mean of the particles. The covariance is the covariance of the hypothesis' Gaussian
/// plus the `errors`.
///
/// `existenceProbability` is the probability that the target is at the estimate. This probability
/// is the product of the hypothesis' probability and 1 - `identityAmbiguity`, where
/// `identityAmbiguity` (0 to 1) is the probability that the hypothesis is an identical object.
/// While no camera sees the target, it is also multiplied by the probability that the target is
/// within its radius of the estimate. `isValid` is true if the hypothesis is more likely than not,
/// regardless of the identity, and the position is known precisely enough to be useful. The
/// function sets the radius of the observation.
SphereEstimate sphereEstimateFrom(const TrackHypothesis& hypothesis, double identityAmbiguity,
                                  const SystematicErrors& errors, SphereObservation& observation);

/// Returns the estimate of a target like sphereEstimateFrom(), but without using images.
/// `seeingCenters` are the optical centers of the cameras that see the target (meters, world
/// frame), and `ofShape` (m²) is the covariance of an additional systematic error.
SphereEstimate estimateFrom(const TrackHypothesis& hypothesis, double identityAmbiguity,
                            const std::vector<Eigen::Vector3d>& seeingCenters,
                            const SystematicErrors& errors, const Eigen::Matrix3d& ofShape);

/// Returns the estimate of a target that is being searched for: the mean and covariance of the
/// search particles. `isValid` is false.
SphereEstimate sphereEstimateFrom(const SearchParticles& particles);

} // namespace dewpoint::tracking
