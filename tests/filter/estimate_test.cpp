// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/estimate.h"
#include "tests/base/not_a_number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dewpoint::tests {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Normalize, WeightsSumToOneInProportion) {
  ThreadTeam team;
  Eigen::ArrayXd logWeights(3);
  logWeights << std::log(1.0), std::log(2.0), std::log(5.0);
  Eigen::ArrayXd weights;
  EXPECT_TRUE(normalize(logWeights, weights, team));
  EXPECT_NEAR(weights[0], 0.125, 1e-15); // 1 / (1 + 2 + 5)
  EXPECT_NEAR(weights[1], 0.25, 1e-15);
  EXPECT_NEAR(weights[2], 0.625, 1e-15);
}

// exp(-100000) is 0 in double precision, yet only differences of log weights count.
TEST(Normalize, SurvivesUnderflow) {
  ThreadTeam team;
  Eigen::ArrayXd logWeights(2);
  logWeights << -100000.0 + std::log(3.0), -100000.0;
  Eigen::ArrayXd weights;
  EXPECT_TRUE(normalize(logWeights, weights, team));
  EXPECT_NEAR(weights[0], 0.75, 1e-10); // 3 : 1; log(3) lost digits beside 100000
  EXPECT_NEAR(weights[1], 0.25, 1e-10);
}

TEST(Normalize, CountsNonFiniteAsZero) {
  ThreadTeam team;
  Eigen::ArrayXd logWeights(5);
  logWeights << kNotANumber, 0.0, -kInfinity, 0.0, kInfinity;
  Eigen::ArrayXd weights;
  EXPECT_TRUE(normalize(logWeights, weights, team));
  EXPECT_EQ(weights[0], 0.0);
  EXPECT_EQ(weights[1], 0.5);
  EXPECT_EQ(weights[2], 0.0);
  EXPECT_EQ(weights[3], 0.5);
  EXPECT_EQ(weights[4], 0.0);
}

TEST(Normalize, AllUselessBecomesUniformAndIsReported) {
  ThreadTeam team;
  Eigen::ArrayXd logWeights(4);
  logWeights << kNotANumber, -kInfinity, -kInfinity, kInfinity;
  Eigen::ArrayXd weights;
  EXPECT_FALSE(normalize(logWeights, weights, team));
  EXPECT_TRUE((weights == 0.25).all());
}

// By hand: x = 0, 2, 4 and y = 1, 1, 5 with weights 1/4, 1/2, 1/4.
// mean x = 1 + 1 = 2, y = 1/4 + 1/2 + 5/4 = 2; deviations x -2, 0, 2 and y -1, -1, 3;
// var x = 4/4 + 4/4 = 2; var y = 1/4 + 1/2 + 9/4 = 3; cov = 2/4 + 0 + 6/4 = 2;
// effective sample size = 1 / (1/16 + 1/4 + 1/16) = 8/3.
TEST(Estimate, HandWorkedSet) {
  Eigen::ArrayXXd states(3, 2);
  states << 0, 1, 2, 1, 4, 5;
  Eigen::ArrayXd weights(3);
  weights << 0.25, 0.5, 0.25;
  const StateEstimate result = estimate(states, weights);
  EXPECT_DOUBLE_EQ(result.mean[0], 2.0);
  EXPECT_DOUBLE_EQ(result.mean[1], 2.0);
  EXPECT_DOUBLE_EQ(result.covariance(0, 0), 2.0);
  EXPECT_DOUBLE_EQ(result.covariance(1, 1), 3.0);
  EXPECT_DOUBLE_EQ(result.covariance(0, 1), 2.0);
  EXPECT_DOUBLE_EQ(result.covariance(1, 0), 2.0);
  EXPECT_DOUBLE_EQ(result.effectiveSampleSize, 8.0 / 3.0);
  EXPECT_EQ(result.bestIndex, 1);
}

TEST(Estimate, EffectiveSampleSizeLimitsAndFirstOfEqualBest) {
  const Eigen::ArrayXXd states = Eigen::ArrayXXd::Zero(8, 3);
  Eigen::ArrayXd weights = Eigen::ArrayXd::Constant(8, 0.125);
  EXPECT_DOUBLE_EQ(estimate(states, weights).effectiveSampleSize, 8.0); // all equal: the count
  EXPECT_EQ(estimate(states, weights).bestIndex, 0);
  weights.setZero();
  weights[5] = 1.0;
  EXPECT_DOUBLE_EQ(estimate(states, weights).effectiveSampleSize, 1.0); // one holds everything
  EXPECT_EQ(estimate(states, weights).bestIndex, 5);
}

} // namespace
} // namespace dewpoint::tests
