// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/track/adaptive_process_noise.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::tracking {
namespace {

// Reasons: docs/method-dewpoint.md, section 1; those without a derivation are judgments.

/// m/s², least process noise; with less the filter would smooth more than its errors are
/// independent.
constexpr double kMinAccelerationSigma = 1.0;
/// Gain with which the acceleration follows the prediction errors, per update, 0 to 1.
constexpr double kLearningRate = 0.15;
/// Largest squared prediction error per axis, in variances, that counts.
constexpr double kMaxInnovation = 9.0;
/// Seconds of the running mean of the velocity; a lasting acceleration shows in how far the
/// velocity runs ahead of it.
constexpr double kVelocityAverageTime = 0.25;
constexpr double kMinLastingAcceleration = 0.3;   ///< m/s²
constexpr double kPriorLastingAcceleration = 2.0; ///< m/s², before anything is known
constexpr double kPriorUpdates = 3.0;             ///< frames that the prior is worth
constexpr double kMemoryUpdates = 30.0;           ///< frames that are remembered
/// Factor of the allowed acceleration for gating: the target's velocity is no more certain than
/// after one step with it.
constexpr double kGateInflation = 1.4;

} // namespace

ConstantVelocity AdaptiveProcessNoise::nextMotion(const ConstantVelocity& allowed) {
  most_ = allowed.accelerationSigma;
  interval_ = allowed.interval;
  const double known = sigma_ > 0.0 ? sigma_ : most_;
  double sigma = std::clamp(known, std::min(kMinAccelerationSigma, most_), most_);
  if (unseenSteps_ > 0) {
    // The k-th step of a lasting acceleration a adds a² t² (2 k - 1) to the velocity's variance.
    const double lasting = learned_ > 0.0 ? std::sqrt(lastingVariance_) : kPriorLastingAcceleration;
    sigma = std::min(most_, std::max(lasting, kMinLastingAcceleration) *
                                std::sqrt(2.0 * unseenSteps_ + 1.0));
  }
  const ConstantVelocity expected{allowed.interval, sigma};
  const ConstantVelocity largest{allowed.interval, kGateInflation * most_};
  Gaussian6 wide;
  wide.covariance = gatingCovariance_;
  largest.predict(wide);
  Gaussian6 narrow;
  narrow.covariance.setZero();
  expected.predict(narrow);
  gatingCovariance_ = wide.covariance - narrow.covariance;
  return expected;
}

void AdaptiveProcessNoise::recordSeen() {
  unseenSteps_ = 0;
  gatingCovariance_.setZero();
}

void AdaptiveProcessNoise::learn(double squaredDistance, const Eigen::Vector3d& velocity) {
  if (most_ <= 0.0 || interval_ <= 0.0) {
    slowVelocity_ = velocity;
    return;
  }
  const double innovation = std::min(squaredDistance / 3.0, kMaxInnovation);
  const double known = sigma_ > 0.0 ? sigma_ : most_;
  sigma_ = std::clamp(known * std::exp(0.5 * kLearningRate * (innovation - 1.0)),
                      std::min(kMinAccelerationSigma, most_), most_);
  // An acceleration a makes the velocity run ahead of its mean over the time T by a T.
  if (learned_ == 0.0) {
    slowVelocity_ = velocity;
    lastingVariance_ = kPriorLastingAcceleration * kPriorLastingAcceleration;
  }
  slowVelocity_ += std::min(1.0, interval_ / kVelocityAverageTime) * (velocity - slowVelocity_);
  const double ahead = (velocity - slowVelocity_).squaredNorm() /
                       (3.0 * kVelocityAverageTime * kVelocityAverageTime);
  learned_ += 1.0;
  const double rate = 1.0 / std::min(learned_ + kPriorUpdates, kMemoryUpdates);
  lastingVariance_ += rate * (ahead - lastingVariance_);
}

} // namespace dewpoint::tracking
