// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/overconfidence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace dewpoint::tests {
namespace {

constexpr double kConfidenceGate = 0.03;

/// A belief in a target at the origin that is `error` meters off along x; standard deviations of 1,
/// 2 and 2 mm state a radius of sqrt(1 + 4 + 4) = 3 mm, and three of them are 9 mm.
ReportedBelief beliefOff(double error, double probability = 1.0) {
  ReportedBelief belief;
  belief.probability = probability;
  belief.isDeclared = probability > 0.5;
  belief.position = {error, 0.0, 0.0};
  belief.covariance = Eigen::Vector3d(1e-6, 4e-6, 4e-6).asDiagonal();
  belief.truth = Eigen::Vector3d::Zero();
  return belief;
}

TEST(Overconfidence, RadiusIsTheStatedRootMeanSquareError) {
  EXPECT_NEAR(reportedRadius(beliefOff(0.0).covariance), 0.003, 1e-15);
  EXPECT_EQ(reportedRadius(Eigen::Matrix3d::Zero()), 0.0);
}

TEST(Overconfidence, SureAndWrongBeyondThreeStatedRadii) {
  EXPECT_FALSE(isConfidentlyWrong(beliefOff(0.0089)));
  EXPECT_TRUE(isConfidentlyWrong(beliefOff(0.0091)));
  EXPECT_FALSE(isConfidentlyWrong(beliefOff(0.0091, 0.95))) << "not above 0.95";
  EXPECT_TRUE(isConfidentlyWrong(beliefOff(0.0091, 0.951)));
  ReportedBelief vague = beliefOff(0.5);
  vague.covariance = 0.04 * Eigen::Matrix3d::Identity(); // radius 0.35 m
  EXPECT_FALSE(isConfidentlyWrong(vague)) << "half a meter off, and says so";
}

TEST(Overconfidence, AnAbsentTargetIsNoExcuse) {
  ReportedBelief belief = beliefOff(0.0);
  belief.truth.reset();
  EXPECT_TRUE(isConfidentlyWrong(belief));
  EXPECT_TRUE(isWrong(belief, kConfidenceGate));
  belief.probability = 0.6;
  EXPECT_FALSE(isConfidentlyWrong(belief));
  EXPECT_TRUE(isWrong(belief, kConfidenceGate)) << "declared, though not sure";
  belief.isDeclared = false;
  EXPECT_FALSE(isWrong(belief, kConfidenceGate));
}

TEST(Overconfidence, NothingUsableIsNoExcuseEither) {
  ReportedBelief belief = beliefOff(0.001);
  belief.covariance.setZero();
  EXPECT_TRUE(isConfidentlyWrong(belief)) << "off, and states no error at all";
  belief.covariance = -Eigen::Matrix3d::Identity();
  EXPECT_TRUE(isConfidentlyWrong(belief));
  belief = beliefOff(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(isConfidentlyWrong(belief));
  EXPECT_TRUE(isWrong(belief, kConfidenceGate));
  belief = beliefOff(0.0);
  belief.covariance.setZero();
  EXPECT_FALSE(isConfidentlyWrong(belief)) << "exactly right";
}

TEST(Overconfidence, SharesAreOfAllBeliefs) {
  // Of five: right; 20 mm off (beyond 9 mm, within the gate); 40 mm off and sure; 40 mm off and
  // not sure; nothing stated, 40 mm off.
  const std::vector<ReportedBelief> beliefs{beliefOff(0.001), beliefOff(0.020), beliefOff(0.040),
                                            beliefOff(0.040, 0.8), beliefOff(0.040, 0.2)};
  const Overconfidence result = measureOverconfidence(beliefs, kConfidenceGate);
  EXPECT_EQ(result.wrongShare.count, 2);
  EXPECT_EQ(result.wrongAndConfidentShare.count, 1);
  EXPECT_EQ(result.confidentlyWrongShare.count, 2);
  for (const Proportion& share :
       {result.wrongShare, result.wrongAndConfidentShare, result.confidentlyWrongShare}) {
    EXPECT_EQ(share.total, 5);
  }
  EXPECT_TRUE(std::isnan(measureOverconfidence({}, kConfidenceGate).wrongShare.value()));
}

} // namespace
} // namespace dewpoint::tests
