// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/dewpoint/search/search_particles.h"
#include "core/tracking/dewpoint/track/track_hypothesis.h"
#include "core/tracking/track_estimate.h"

namespace dewpoint::tracking {

/// What is wrong in all frames alike, so that no number of frames averages it away.
struct SystematicErrors {
  /// Radians, standard deviation of the direction in which a camera sees a point, along each axis:
  /// what its calibration is off by.
  double direction = 0.0;
  /// Seconds, standard deviation of the time of an image.
  double time = 0.0;
};

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

/// The estimate of a target that is searched for: moments of the particles; not valid.
SphereEstimate sphereEstimateFrom(const SearchParticles& particles);

} // namespace dewpoint::tracking
