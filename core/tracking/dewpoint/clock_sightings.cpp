// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/clock_sightings.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::tracking {
namespace {

/// Standard deviations by which the velocity must differ from zero: a target at rest says nothing
/// about times, and the noise of its velocity must not seem to. A judgment.
constexpr double kLeastSpeedSigmas = 3.0;

} // namespace

std::vector<ClockEstimator::Sighting> clockSightings(const TrackedObjects& objects) {
  std::vector<ClockEstimator::Sighting> sightings;
  for (std::size_t k = 0; k < objects.targetCount(); ++k) {
    const TrackHypothesis* const found =
        objects[k].isBall() ? objects[k].track.confidentHypothesis() : nullptr;
    if (found == nullptr) {
      continue;
    }
    const double speedSigma = std::sqrt(found->gaussian.covariance.diagonal().tail<3>().maxCoeff());
    if (found->velocity().norm() < kLeastSpeedSigmas * speedSigma) {
      continue;
    }
    // A frame in which the cameras disagree more than usual has something else wrong with it: a
    // duplicated image, or a target that is partly hidden.
    const double trust =
        found->isSaturated()
            ? 1.0 / std::max({1.0, found->meanCameraDisagreement, found->lastCameraDisagreement})
            : 0.0;
    sightings.push_back({found->position(), found->velocity(), &found->cameraInformation, trust});
  }
  return sightings;
}

} // namespace dewpoint::tracking
