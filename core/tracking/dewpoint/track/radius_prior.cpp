// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/track/radius_prior.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::tracking {
namespace {

// Reasons: docs/method-dewpoint.md, section 5; those without a derivation are judgments. All but
// the first are of the logarithm of the radius.

/// Meters, radius of a target that is searched for while its radius is not known. Origin not
/// recorded.
constexpr double kAssumedRadius = 0.03;
constexpr double kRadiusSigma = 0.2;   ///< of a radius that is read off the images
constexpr double kGivenSigma = 0.05;   ///< of a radius that somebody gave, unless it is mistaken
constexpr double kMostPenalty = 8.0;   ///< nats: the odds that it is mistaken, 1 to 3000
constexpr double kTrusted = 0.06;      ///< a given radius agrees with an outline that is so far off
constexpr double kLearnedSigma = 0.05; ///< a radius that is known so well is remembered
constexpr double kMostOff = 0.4;       ///< by a factor of 1.5: farther off is another object

} // namespace

void RadiusPrior::learn(double radius, double logVariance) {
  if (logVariance > 0.0 && logVariance < kLearnedSigma * kLearnedSigma) {
    measured_ = radius;
  }
}

double RadiusPrior::expectedRadius() const {
  return measured_ > 0.0 ? measured_ : isGiven() ? given_ : kAssumedRadius;
}

double RadiusPrior::unknownRadiusLogVariance() {
  return kRadiusSigma * kRadiusSigma;
}

bool RadiusPrior::contradicts(double radius) const {
  return isGiven() && std::abs(std::log(radius / given_)) > kTrusted;
}

double RadiusPrior::penaltyFor(double radius) const {
  if (measured_ <= 0.0 && !isGiven()) {
    return 0.0;
  }
  const double off = std::log(radius / expectedRadius()) / kGivenSigma;
  return std::min(0.5 * off * off, kMostPenalty);
}

bool RadiusPrior::allowsRadius(double radius) const {
  return (measured_ <= 0.0 && !isGiven()) ||
         std::abs(std::log(radius / expectedRadius())) <= kMostOff;
}

} // namespace dewpoint::tracking
