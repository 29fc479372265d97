// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/dynamics_study.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dewpoint::tests {
namespace {

TEST(DynamicsStudy, TheJumpIsSeenAtItsIteration) {
  const DynamicsSetup setup;
  const DynamicsRun run = runDynamics(setup, 1, {29, 40});
  ASSERT_EQ(run.errors.size(), 100U);
  EXPECT_LT(run.errors[29], 0.05);
  EXPECT_NEAR(run.errors[30], 2.0, 0.2); // the paper's figure 6
  EXPECT_LT(run.errors[99], 0.05);
  ASSERT_EQ(run.particleClouds.size(), 2U);
  // What is said of the cloud is what is drawn of it: the mean square distance is the sum of the
  // variances.
  const Eigen::ArrayXXd& cloud = run.particleClouds[1];
  double square = 0.0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    square += (cloud.col(axis) - cloud.col(axis).mean()).square().mean();
  }
  EXPECT_NEAR(run.cloudSpreads[40], std::sqrt(square), 1e-12);
  // Two iterations after the jump few particles have all the weight; the random step alone, 0.03 m
  // per axis, spreads the cloud by 0.052 m.
  EXPECT_GT(run.cloudSpreads[32], 0.045);
  EXPECT_LT(run.beliefSpreads[32], 0.5 * run.cloudSpreads[32]);
  EXPECT_EQ(run.particleClouds[0].rows(), 200);
}

TEST(DynamicsStudy, ALargerSigmaArrivesSoonerAndWider) {
  DynamicsSetup small;
  DynamicsSetup large;
  large.motionSigma = 0.15;
  const DynamicsRun slow = runDynamics(small, 1);
  const DynamicsRun fast = runDynamics(large, 1);
  const auto again = [](const DynamicsRun& run) {
    return iterationsUntilErrorBelow(run.errors, 30, 100, 0.1);
  };
  EXPECT_LT(again(fast), again(slow));
  EXPECT_GT(fast.cloudSpreads[99], slow.cloudSpreads[99]);
  EXPECT_GT(fast.beliefSpreads[99], slow.beliefSpreads[99]);
}

TEST(DynamicsStudy, ATinySigmaDoesNotArriveBeforeIterationSeventy) {
  DynamicsSetup setup;
  setup.motionSigma = 0.005;
  setup.startPosition = setup.positionBeforeJump;
  EXPECT_GT(runDynamics(setup, 1).errors[69], 1.0);
}

TEST(DynamicsStudy, CountsIterationsUntilItStaysBelow) {
  const std::vector<double> errors{2.0, 0.05, 0.2, 0.05, 0.04};
  EXPECT_EQ(iterationsUntilErrorBelow(errors, 0, 5, 0.1), 4) << "the second is not for good";
  EXPECT_EQ(iterationsUntilErrorBelow(errors, 3, 5, 0.1), 1);
  EXPECT_EQ(iterationsUntilErrorBelow(errors, 0, 3, 0.1), -1);
}

TEST(DynamicsStudy, ACloudMovesByTheFarthestOfItsParticles) {
  DynamicsSetup setup;
  setup.motionSigma = 0.06;
  // Expected largest of 200 standard normals: 2.746. Far away only the nearest particle survives.
  const double most = distanceAdvancedTowardFarObject(setup, 10);
  EXPECT_NEAR(most / setup.motionSigma, 2.746, 0.1);
  EXPECT_LT(findMaxTrackableSpeed(setup, 4), most);
}

} // namespace
} // namespace dewpoint::tests
