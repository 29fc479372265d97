// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/track/adaptive_process_noise.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>

namespace dewpoint::tests {
namespace {

constexpr double kInterval = 1.0 / 30.0;
constexpr ConstantVelocity kAllowed{kInterval, 8.0};

/// The standard deviation along X after so many steps from a position and velocity known exactly.
double spreadAfter(AdaptiveProcessNoise& processNoise, int steps) {
  Gaussian6 state;
  state.covariance.setZero();
  for (int step = 0; step < steps; ++step) {
    processNoise.nextMotion(kAllowed).predict(state);
    processNoise.recordUnseen();
  }
  return std::sqrt(state.covariance(0, 0));
}

TEST(AdaptiveProcessNoise, AllowsEverythingAtFirst) {
  AdaptiveProcessNoise processNoise;
  EXPECT_EQ(processNoise.nextMotion(kAllowed).accelerationSigma, 8.0);
  EXPECT_EQ(processNoise.nextMotion(kAllowed).interval, kInterval);
  EXPECT_EQ(processNoise.unseenStepCount(), 0);
}

TEST(AdaptiveProcessNoise, LearnsCalmWithinASecondAndUnrestAtOnce) {
  AdaptiveProcessNoise processNoise;
  processNoise.nextMotion(kAllowed);
  for (int frame = 0; frame < 30; ++frame) { // predicted to a third of what was expected
    processNoise.learn(0.3, {0.1, 0.0, 0.0});
  }
  EXPECT_LT(processNoise.nextMotion(kAllowed).accelerationSigma, 2.5);
  for (int frame = 0; frame < 300; ++frame) {
    processNoise.learn(0.3, {0.1, 0.0, 0.0});
  }
  EXPECT_GE(processNoise.nextMotion(kAllowed).accelerationSigma, 0.5); // no hand is that calm
  for (int frame = 0; frame < 4; ++frame) {
    processNoise.learn(100.0, {0.1, 0.0, 0.0});
  }
  EXPECT_GT(processNoise.nextMotion(kAllowed).accelerationSigma, 6.0);
  EXPECT_LE(processNoise.nextMotion(kAllowed).accelerationSigma, 8.0); // never more than allowed
}

TEST(AdaptiveProcessNoise, WhatIsAsUncertainAsStatedStaysAsItIs) {
  AdaptiveProcessNoise processNoise;
  processNoise.nextMotion({kInterval, 3.0});
  for (int frame = 0; frame < 100; ++frame) {
    processNoise.learn(3.0, Eigen::Vector3d::Zero()); // the mean of chi-square with three degrees
  }
  EXPECT_NEAR(processNoise.nextMotion(kAllowed).accelerationSigma, 3.0, 1e-9);
}

// A velocity that grows by 2 m/s every second along each axis: after half a second without sight
// the position is off by 2 t² / 2 = 0.25 m. The sum over steps gives 0.8 of that.
TEST(AdaptiveProcessNoise, WithoutSightAnAccelerationThatWasSeenLasts) {
  AdaptiveProcessNoise processNoise;
  processNoise.nextMotion(kAllowed);
  for (int frame = 0; frame < 120; ++frame) {
    processNoise.learn(3.0, Eigen::Vector3d::Constant(2.0 * kInterval * frame));
  }
  processNoise.nextMotion(kAllowed);
  processNoise.recordUnseen();
  EXPECT_NEAR(spreadAfter(processNoise, 15), 0.25, 0.1);
}

TEST(AdaptiveProcessNoise, WithoutSightACalmTargetStaysPredictable) {
  AdaptiveProcessNoise processNoise;
  processNoise.nextMotion(kAllowed);
  for (int frame = 0; frame < 120; ++frame) {
    processNoise.learn(1.0, {0.2, 0.0, 0.1});
  }
  processNoise.nextMotion(kAllowed);
  processNoise.recordUnseen();
  EXPECT_LT(spreadAfter(processNoise, 10), 0.03);
}

TEST(AdaptiveProcessNoise, TheMarginMakesUpForWhatIsAllowed) {
  AdaptiveProcessNoise processNoise;
  processNoise.nextMotion(kAllowed);
  for (int frame = 0; frame < 300; ++frame) {
    processNoise.learn(0.3, {0.2, 0.0, 0.1});
  }
  processNoise.recordSeen();
  Gaussian6 state;
  state.covariance.setZero();
  Gaussian6 allowed = state;
  for (int step = 0; step < 10; ++step) {
    processNoise.nextMotion(kAllowed).predict(state);
    kAllowed.predict(allowed);
    processNoise.recordUnseen();
    const Gaussian6::Matrix total = state.covariance + processNoise.gatingCovariance();
    EXPECT_GE(total(0, 0), allowed.covariance(0, 0)) << step;
    EXPECT_LT(total(0, 0), 3.0 * allowed.covariance(0, 0)) << step;
    const Eigen::SelfAdjointEigenSolver<Gaussian6::Matrix> eigen(total);
    EXPECT_GT(eigen.eigenvalues()[0], -1e-12) << step;
  }
  processNoise.recordSeen();
  EXPECT_EQ(processNoise.unseenStepCount(), 0);
  EXPECT_TRUE(processNoise.gatingCovariance().isZero());
}

} // namespace
} // namespace dewpoint::tests
