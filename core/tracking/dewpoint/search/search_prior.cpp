// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/search/search_prior.h"

#include "core/filter/prepared_gaussian.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewpoint::tracking {
namespace {

// Reasons: docs/method-dewpoint.md, section 5. They are judgments, not measurements.

/// Share of the birth density that this prior has, 0 to 1; the rest is uniform over the room.
constexpr double kSearchPriorShare = 0.5;
/// Meters, least standard deviation along each axis: the target may have moved since.
constexpr double kMinSearchPriorSigma = 0.1;
/// m/s by which the standard deviation grows while no position is confirmed.
constexpr double kSearchPriorSpeed = 0.5;
/// Meters, standard deviation beyond which the last position says nothing about the next one.
/// Origin not recorded.
constexpr double kMaxExpectedSigma = 1.0;

} // namespace

void SearchPrior::restart(const StartVolume& start) {
  start_ = start;
  gaussian_.mean = start.center;
  // A uniform distribution of half size h has the standard deviation h / sqrt(3).
  gaussian_.covariance = (start.halfSize / std::sqrt(3.0))
                             .array()
                             .max(kMinSearchPriorSigma)
                             .square()
                             .matrix()
                             .asDiagonal();
  wasConfirmed_ = false;
}

void SearchPrior::confirmPosition(const Gaussian3& position) {
  gaussian_ = position;
  gaussian_.covariance.diagonal().array() += kMinSearchPriorSigma * kMinSearchPriorSigma;
  wasConfirmed_ = true;
}

void SearchPrior::widen(double interval, double maxSigma) {
  if (!wasConfirmed_) {
    return;
  }
  // A standard deviation that grows linearly with time.
  const double sigma = std::sqrt(gaussian_.covariance.trace() / 3.0);
  const double wider = std::min(sigma + kSearchPriorSpeed * interval, maxSigma);
  gaussian_.covariance *= (wider * wider) / (sigma * sigma);
}

double SearchPrior::birthDensity(const Eigen::Vector3d& position, double searchCubeEdge,
                                 const std::optional<WorldBox>& bounds) const {
  if (bounds && !bounds->contains(position)) {
    return 0.0;
  }
  const double room = searchCubeEdge * searchCubeEdge * searchCubeEdge;
  double near = 0.0;
  if (wasConfirmed_) {
    near = std::exp(PreparedGaussian3(gaussian_).logDensity(position));
  } else {
    // Higher at the center of the start box than near its walls: of two objects that look the same,
    // the one nearer to the given start is meant.
    const Eigen::Array3d sigma = (0.5 * start_.halfSize.array()).max(0.5 * kMinSearchPriorSigma);
    const Eigen::Array3d off = (position - start_.center).array() / sigma;
    near = std::exp(-0.5 * off.square().sum()) /
           (std::pow(2.0 * std::numbers::pi, 1.5) * sigma.prod());
  }
  return kSearchPriorShare * near + (1.0 - kSearchPriorShare) / room;
}

Eigen::ArrayXXd SearchPrior::drawPositions(Eigen::Index count, const RandomStream& stream) const {
  if (!wasConfirmed_) {
    return drawUniformPositions(start_, count, stream);
  }
  return PreparedGaussian3(gaussian_).draw(count, stream);
}

std::optional<Eigen::Vector3d> SearchPrior::lastPosition() const {
  const double sigma = std::sqrt(gaussian_.covariance.trace() / 3.0);
  return wasConfirmed_ && sigma <= kMaxExpectedSigma ? std::optional(gaussian_.mean) : std::nullopt;
}

} // namespace dewpoint::tracking
