// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/clock_sightings.h"

#include <cmath>

namespace dewpoint::tracking {
namespace {

/// Standard deviations by which the velocity must differ from zero: a target at rest says nothing
/// about times, and the noise of its velocity must not seem to. A judgment.
constexpr double kLeastSpeedSigmas = 3.0;

} // namespace

std::vector<ClockEstimator::Sighting> clockSightings(TrackedObjects& objects) {
  std::vector<ClockEstimator::Sighting> sightings;
  for (std::size_t k = 0; k < objects.targetCount(); ++k) {
    TrackedObject& object = objects[k];
    const TrackHypothesis* const found =
        object.isBall() ? object.track.confidentHypothesis() : nullptr;
    if (found == nullptr || !found->outlineFound || found->oneCameraOnly) {
      continue;
    }
    const double speedSigma = std::sqrt(found->gaussian.covariance.diagonal().tail<3>().maxCoeff());
    if (found->velocity().norm() < kLeastSpeedSigmas * speedSigma) {
      continue;
    }
    object.observation.setRadius(found->radius);
    sightings.push_back({found->position(), found->velocity(),
                         object.observation.fitEachCamera(found->position(), found->velocity())});
  }
  return sightings;
}

} // namespace dewpoint::tracking
