// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/region/roundness.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewpoint::observation {
namespace {

// Judgments (docs/method-dewpoint.md, section 12).

/// Standard deviations of a ball's figures: blur, the dark side, the raster.
constexpr double kBallElongation = 0.08;
constexpr double kBallHollowness = 0.04;
constexpr double kBallExcess = 0.15;
/// Means of those of other things: a cap seen from the side, a cone.
constexpr double kOtherElongation = 0.5;
constexpr double kOtherHollowness = 0.15;
constexpr double kOtherExcess = 0.5;
/// Share of the images of a ball that look like anything: something of its color touches it.
constexpr double kSpoiledShare = 0.03;
/// Areas of the ball up to which a region is one with another thing of its color and size that
/// touches it.
constexpr double kTouching = 2.0;
/// Pixels, least area: of a smaller one the raster decides.
constexpr double kLeastRoundArea = 80.0;
/// Largest share of the rim that something else than the target may end.
constexpr double kMostRoundOpen = 0.2;

double exponential(double value, double mean) {
  return std::exp(-value / mean) / mean;
}

double halfNormal(double value, double sigma) {
  return std::sqrt(2.0 / std::numbers::pi) / sigma *
         std::exp(-0.5 * value * value / (sigma * sigma));
}

double logRatio(double value, double ballSigma, double otherMean) {
  const double other = exponential(value, otherMean);
  return std::log(other) -
         std::log((1.0 - kSpoiledShare) * halfNormal(value, ballSigma) + kSpoiledShare * other);
}

} // namespace

Roundness roundnessOf(const ColorRegion& region, const EllipseImage& ball) {
  // Relative to the ball's own outline both of its eigenvalues would be equal.
  const Eigen::Matrix2d relative = ball.extent.inverse() * region.covariance;
  const double mean = 0.5 * relative.trace();
  const double determinant = std::max(0.0, relative.determinant());
  const double root = std::sqrt(std::max(0.0, mean * mean - determinant));
  const double ellipse = 4.0 * std::numbers::pi * std::sqrt(region.covariance.determinant());
  return {0.5 * std::log((mean + root) / std::max(mean - root, 1e-6 * mean)),
          std::max(0.0, 1.0 - region.area / ellipse),
          std::max(0.0, 0.5 * std::log(region.area / (kTouching * ball.area())))};
}

std::optional<double> shapeEvidence(const ColorRegion& region, const EllipseImage& ball) {
  if (region.area < kLeastRoundArea) {
    return std::nullopt;
  }
  const Roundness round = roundnessOf(region, ball);
  // What is no ball has regions of all sizes where one of its size was found: that they fit says
  // nothing.
  const double ofSize = std::max(0.0, logRatio(round.sizeExcess, kBallExcess, kOtherExcess));
  if (region.cutOffShare() > kMostRoundOpen) {
    return ofSize > 0.0 ? std::optional(ofSize) : std::nullopt;
  }
  return ofSize + logRatio(round.elongation, kBallElongation, kOtherElongation) +
         logRatio(round.hollowness, kBallHollowness, kOtherHollowness);
}

} // namespace dewpoint::observation
