// SPDX-License-Identifier: GPL-3.0-or-later
// What a BernoulliTrack tells others: its estimate and its particles.
#include "core/filter/estimate.h"
#include "core/filter/evenly_picked.h"
#include "core/tracking/dewpoint/bernoulli_track.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewpoint::tracking {
namespace {

/// An estimate wider than this many radii, or this many metres, says nothing of use.
constexpr double kUsefulRadii = 3.0;
constexpr double kUsefulSigma = 0.1;

/// A target that is not seen is declared while it is likelier than not within its radius, at least
/// this many meters, of the estimate.
constexpr double kNearby = 0.03;

/// Where a lost target was seen last says where it is expected until the place is this uncertain.
constexpr double kExpectedSigma = 1.0; // metres

/// Probability that a normal vector of mean zero is shorter than `radius`: its squared length is
/// taken for a scaled chi-square variable of the same mean and variance (Satterthwaite 1946), whose
/// cube root is nearly normal (Wilson and Hilferty 1931).
double probabilityWithin(const Eigen::Matrix3d& covariance, double radius) {
  const double trace = covariance.trace();
  const double freedoms = trace * trace / covariance.squaredNorm();
  const double variance = 2.0 / (9.0 * freedoms);
  const double off = (std::cbrt(radius * radius / trace) - (1.0 - variance)) / std::sqrt(variance);
  return 0.5 * std::erfc(-off / std::numbers::sqrt2);
}

/// Probability that the place of a hypothesis still holds, if the target is there at all.
double probabilityWithinRadius(const TrackHypothesis& hypothesis) {
  return hypothesis.processNoise.unseenSteps() == 0
             ? 1.0
             : probabilityWithin(hypothesis.gaussian.covariance.topLeftCorner<3, 3>(),
                                 std::max(kNearby, hypothesis.radius));
}

bool isUseful(const TrackHypothesis& hypothesis) {
  const double variance = hypothesis.gaussian.covariance.diagonal().head<3>().maxCoeff();
  const double sigma = std::max(kUsefulSigma, kUsefulRadii * hypothesis.radius);
  return variance < sigma * sigma;
}

} // namespace

SphereEstimate BernoulliTrack::estimate(SphereObservation& observation) const {
  SphereEstimate result;
  const TrackHypothesis* likeliest = best();
  const bool searching = likeliest == nullptr || likeliest->states.rows() == 0;
  const StateEstimate moments =
      searching ? dewpoint::filter::estimate(cloud_.states, cloud_.weights)
                : dewpoint::filter::estimate(likeliest->states, likeliest->weights);
  const auto& states = searching ? cloud_.states : likeliest->states;
  result.mean = moments.mean.head<3>();
  result.best = states.row(moments.bestIndex).head(3).transpose();
  result.covariance = moments.covariance.topLeftCorner<3, 3>();
  result.effectiveSampleSize = moments.effectiveSampleSize;
  result.particleCount = static_cast<int>(states.rows());
  result.degenerate = moments.degenerate;
  if (searching) {
    return result;
  }
  result.covariance = likeliest->gaussian.covariance.topLeftCorner<3, 3>();
  if (likeliest->outlineFound) {
    result.measurement = likeliest->measurement;
  }
  const double near = probabilityWithinRadius(*likeliest);
  result.existence = std::min(1.0, likeliest->probability) * (1.0 - identityAmbiguity_) * near;
  result.radius = likeliest->radius;
  observation.setRadius(likeliest->radius);
  result.cameras = observation.evidence(result.mean, likeliest->velocity());
  result.camerasSeeing = SphereObservation::camerasSeeing(result.cameras);
  result.valid = likeliest->probability * near > 0.5 && isUseful(*likeliest);
  return result;
}

std::optional<OccupiedSphere> BernoulliTrack::expected() const {
  const TrackHypothesis* likeliest = best();
  if (likeliest != nullptr) {
    return OccupiedSphere{likeliest->position(), likeliest->radius};
  }
  const double sigma = std::sqrt(searchPrior_.covariance.trace() / 3.0);
  if (!everSeen_ || sigma > kExpectedSigma) {
    return std::nullopt;
  }
  return OccupiedSphere{searchPrior_.mean, target_.radius > 0.0 ? target_.radius : kNearby};
}

std::size_t BernoulliTrack::memoryBytes() const {
  auto numbers = cloud_.states.size() + cloud_.weights.size();
  for (const auto* hypotheses : {&hypotheses_, &predicted_}) {
    for (const TrackHypothesis& hypothesis : *hypotheses) {
      numbers += hypothesis.states.size() + hypothesis.weights.size();
    }
  }
  return sizeof(double) * static_cast<std::size_t>(numbers);
}

void BernoulliTrack::particles(int limit, Eigen::ArrayXXd& positions,
                               Eigen::ArrayXd& weights) const {
  const TrackHypothesis* sure = confident();
  const Eigen::ArrayXXd& states = sure != nullptr ? sure->states : cloud_.states;
  const Eigen::ArrayXd& all = sure != nullptr ? sure->weights : cloud_.weights;
  pickEvenly(states, all, limit, 3, positions, weights);
}

} // namespace dewpoint::tracking
