// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/bundle/bundle_model.h"
#include "tests/calibration/bundle/bundle_rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace dewpoint::tests {
namespace {

using abreast::ballAt;
using abreast::ballSeenAt;
using abreast::kSix;

BundleStart startOf(const BundleProblem& problem) {
  auto start = initializeBundle(problem);
  EXPECT_TRUE(start) << errorSentence(start.error());
  return std::move(*start);
}

/// Half the sum of the squared residuals, weighed by the loss.
double costOf(BundleModel& model) {
  double cost = -1.0;
  EXPECT_TRUE(model.ceresProblem.Evaluate({}, &cost, nullptr, nullptr, nullptr));
  return cost;
}

TEST(BundleModel, BlocksHoldTheStart) {
  const BundleProblem problem = ballSeenAt(kSix);
  BundleModel model(problem, startOf(problem));
  ASSERT_EQ(model.cameras.size(), 2U);
  // A turn of nothing against the start, and the center.
  EXPECT_EQ(model.cameras[1].pose, (std::array<double, 6>{0, 0, 0, 1, 0, 0}));
  EXPECT_EQ(model.cameras[1].lens,
            (std::array<double, kLensSize>{500, 1, 320, 240, 0, 0, 0, 0, 0, 0, 0, 0}));
  ASSERT_EQ(model.states.size(), 6U);
  EXPECT_LT((Eigen::Map<const Eigen::Vector3d>(model.states[2].values.data()) - ballAt(0.2)).norm(),
            1e-9);
  EXPECT_EQ(model.usedObservationCount, 12U);
  EXPECT_EQ(model.ceresProblem.NumResidualBlocks(), 12);
  // Pose, lens and offset of the camera that looks, and the state.
  EXPECT_EQ(model.blocksOf(5),
            (std::vector<double*>{model.cameras[1].pose.data(), model.cameras[1].lens.data(),
                                  &model.cameras[1].timeOffset, model.states[2].values.data()}));
  EXPECT_NEAR(costOf(model), 0.0, 1e-15); // the pixels are exact
}

// 3 px beside it along x and 4 along y, at a sigma of 0.5 px: 6 and 8 sigmas, half of 100.
TEST(BundleModel, AResidualCountsInSigmas) {
  BundleProblem problem = ballSeenAt(kSix);
  BundleStart start = startOf(problem);
  problem.observations[4].pixel += Eigen::Vector2d(3.0, 4.0);
  problem.observations[4].sigma = 0.5;
  BundleModel squares(problem, start);
  EXPECT_NEAR(costOf(squares), 50.0, 1e-9);
  // The losses of Ceres, of s = 100 squared sigmas and a width of 1 px, 2 sigmas:
  problem.lossWidth = 1.0;
  // Huber: 2 * 2 sqrt(s) - 2² = 36; half of it.
  problem.loss = RobustLoss::Huber;
  BundleModel huber(problem, start);
  EXPECT_NEAR(costOf(huber), 18.0, 1e-9);
  // Soft L1: 2 * 2² (sqrt(1 + s / 2²) - 1).
  problem.loss = RobustLoss::SoftL1;
  BundleModel soft(problem, start);
  EXPECT_NEAR(costOf(soft), 4.0 * (std::sqrt(26.0) - 1.0), 1e-9);
  // Cauchy: 2² log(1 + s / 2²).
  problem.loss = RobustLoss::Cauchy;
  BundleModel cauchy(problem, start);
  EXPECT_NEAR(costOf(cauchy), 2.0 * std::log(26.0), 1e-9);
  EXPECT_EQ(cauchy.lossesBySigma.size(), 2U); // one for each sigma
}

TEST(BundleModel, WhatIsBehindACameraIsNotUsed) {
  const BundleProblem problem = ballSeenAt(kSix);
  BundleStart start = startOf(problem);
  start.states[3].ends[0].z() = -4.0;
  BundleModel model(problem, start);
  EXPECT_EQ(model.usedObservationCount, 10U);
  EXPECT_FALSE(model.start.isObservationUsed[6]);
  EXPECT_FALSE(model.start.isObservationUsed[7]);
  EXPECT_EQ(model.costFunctions[6], nullptr);
  EXPECT_NE(model.costFunctions[5], nullptr);
  EXPECT_FALSE(model.isInProblem(model.states[3].values.data()));
}

TEST(BundleModel, OnlyWhatIsFreeVaries) {
  BundleProblem problem = ballSeenAt(kSix);
  problem.cameras[0].isPoseFixed = true;
  problem.cameras[1].isFocalFree = true;
  problem.cameras[1].isTimeOffsetFree = true;
  problem.states[5].isFixed = true;
  problem.states[5].ends[0] = ballAt(0.5);
  BundleModel model(problem, startOf(problem));
  EXPECT_FALSE(model.isVariable(model.cameras[0].pose.data()));
  EXPECT_TRUE(model.isVariable(model.cameras[1].pose.data()));
  EXPECT_FALSE(model.isVariable(model.cameras[0].lens.data()));
  EXPECT_TRUE(model.isVariable(model.cameras[1].lens.data()));
  EXPECT_FALSE(model.isVariable(&model.cameras[0].timeOffset));
  EXPECT_TRUE(model.isVariable(&model.cameras[1].timeOffset));
  EXPECT_TRUE(model.isVariable(model.states[0].values.data()));
  EXPECT_FALSE(model.isVariable(model.states[5].values.data()));
  // Of the lens one number of twelve: the focal length.
  EXPECT_EQ(model.ceresProblem.ParameterBlockTangentSize(model.cameras[1].lens.data()), 1);
  EXPECT_EQ(model.ceresProblem.ParameterBlockSize(model.cameras[1].lens.data()), kLensSize);
}

TEST(BundleModel, EntriesOfALensAreHeldOneByOne) {
  BundleCamera camera = abreast::cameraAt(0.0);
  std::vector<int> all(kLensSize);
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(BundleModel::fixedLensEntries(camera), all);
  camera.isFocalFree = true;          // entry 0
  camera.isPrincipalPointFree = true; // 2 and 3
  camera.isDistortionFree[0] = true;  // 4
  camera.isDistortionFree[7] = true;  // 11
  EXPECT_EQ(BundleModel::fixedLensEntries(camera), (std::vector<int>{1, 5, 6, 7, 8, 9, 10}));
  camera.isAspectFree = true;
  camera.isDistortionFree.fill(true);
  EXPECT_TRUE(BundleModel::fixedLensEntries(camera).empty());
}

// A stick that is 1 cm longer than it is known to be to 5 mm: two sigmas, half of 4.
TEST(BundleModel, ASticksLengthIsAResidual) {
  BundleProblem problem;
  problem.cameras = {abreast::cameraAt(0.0), abreast::cameraAt(1.0)};
  problem.bodies.push_back({"stick", BundleBody::Kind::Stick, 0.49, 0.005});
  for (std::size_t k = 0; k < 3; ++k) {
    BundleState state;
    state.time = double(k);
    problem.states.push_back(state);
    for (std::size_t c = 0; c < 2; ++c) {
      for (std::size_t point = 0; point < 2; ++point) {
        BundleObservation seen;
        seen.camera = c;
        seen.state = k;
        seen.point = point;
        const Eigen::Vector3d end(0.5 * double(point), 0.1 * double(k), 4.0);
        seen.pixel = abreast::pixelOf(double(c), end);
        problem.observations.push_back(seen);
      }
    }
  }
  BundleModel model(problem, startOf(problem));
  EXPECT_EQ(model.ceresProblem.NumResidualBlocks(), 12 + 3);
  EXPECT_NEAR(costOf(model), 3.0 * 2.0, 1e-6);
}

// The pose starts at its prior; 3 cm away at 1 cm its prior costs half of 9. So does that of a
// focal length that is 6 % off at 2 %.
TEST(BundleModel, PriorsPullToTheStart) {
  BundleProblem problem = ballSeenAt(kSix);
  problem.cameras[1].posePrior = PosePrior{0.01, 0.01};
  problem.cameras[1].isFocalFree = true;
  problem.cameras[1].focalPriorSigma = 0.02;
  BundleStart start = startOf(problem);
  BundleModel model(problem, start);
  EXPECT_EQ(model.ceresProblem.NumResidualBlocks(), 12 + 2);
  EXPECT_NEAR(costOf(model), 0.0, 1e-15);
  std::vector<ceres::ResidualBlockId> priors;
  model.ceresProblem.GetResidualBlocksForParameterBlock(model.cameras[1].pose.data(), &priors);
  ASSERT_EQ(priors.size(), 7U); // six images and the prior, which was added last
  model.cameras[1].pose[3] += 0.03;
  model.cameras[1].lens[0] *= 1.06;
  double cost = 0.0;
  ASSERT_TRUE(
      model.ceresProblem.EvaluateResidualBlock(priors.back(), false, &cost, nullptr, nullptr));
  EXPECT_NEAR(cost, 4.5, 1e-9);
  model.ceresProblem.GetResidualBlocksForParameterBlock(model.cameras[1].lens.data(), &priors);
  ASSERT_EQ(priors.size(), 7U);
  ASSERT_TRUE(
      model.ceresProblem.EvaluateResidualBlock(priors.back(), false, &cost, nullptr, nullptr));
  EXPECT_NEAR(cost, 4.5, 1e-9);
}

TEST(BundleModel, ALateImageDependsOnTheStatesAroundIt) {
  BundleProblem problem = ballSeenAt(kSix);
  problem.cameras[1].isTimeOffsetFree = true;
  BundleModel model(problem, startOf(problem));
  // Camera 2 at the third instant: its own blocks and those of instants 0 to 4.
  const auto blocks = model.blocksOf(5);
  ASSERT_EQ(blocks.size(), 3U + 5U);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(blocks[3 + k], model.states[k].values.data());
  }
  EXPECT_EQ(model.blocksOf(4).size(), 4U); // camera 1 is on time
  EXPECT_NEAR(costOf(model), 0.0, 1e-12);
  // 10 ms later the ball is 10 mm, 5 mm and 2 mm farther; the path of five instants on a straight
  // line says so exactly.
  model.cameras[1].timeOffset = 0.01;
  const Eigen::Vector2d off =
      abreast::pixelOf(1.0, ballAt(0.21)) - abreast::pixelOf(1.0, ballAt(0.2));
  std::vector<ceres::ResidualBlockId> all;
  model.ceresProblem.GetResidualBlocks(&all);
  double cost = 0.0;
  ASSERT_TRUE(model.ceresProblem.EvaluateResidualBlock(all[5], false, &cost, nullptr, nullptr));
  EXPECT_NEAR(cost, 0.5 * off.squaredNorm(), 1e-9);
}

} // namespace
} // namespace dewpoint::tests
