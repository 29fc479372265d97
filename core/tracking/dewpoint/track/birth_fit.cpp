// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/track/birth_fit.h"

#include <Eigen/Core>

namespace dewpoint::tracking {
namespace {

/// By this much the log likelihood ratio must be larger with another radius than the given one. A
/// judgment (docs/method-dewpoint.md, section 5).
constexpr double kOtherRadiusGain = 3.0;

} // namespace

OutlineFit fitCandidateOutline(const Candidate& candidate, const RadiusPrior& radius,
                               double searchCubeEdge, SphereObservation& observation) {
  OutlinePrior prior;
  prior.center = candidate.center;
  prior.radius = radius.isGiven() ? radius.expectedRadius() : candidate.radius;
  prior.logRadiusVariance = radius.logVariance();
  prior.information = Eigen::Matrix3d::Identity() / (searchCubeEdge * searchCubeEdge);
  const OutlineFit fit = observation.fit(prior, Eigen::Vector3d::Zero());
  if (!radius.isTrusted()) {
    return fit;
  }
  prior.logRadiusVariance = RadiusPrior::unknownRadiusLogVariance();
  const OutlineFit free = observation.fit(prior, Eigen::Vector3d::Zero());
  if (!free.isFound || !radius.contradicts(free.radius)) {
    return fit;
  }
  const auto evidence = [&observation](const OutlineFit& of) {
    observation.setRadius(of.radius);
    return of.isFound ? observation.logLikelihoodRatio(of.center, Eigen::Vector3d::Zero()) : 0.0;
  };
  return evidence(free) > evidence(fit) + kOtherRadiusGain ? free : fit;
}

} // namespace dewpoint::tracking
