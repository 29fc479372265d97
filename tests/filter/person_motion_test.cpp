// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/person_motion.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

const RandomStream kStream(1, 2, 0, RandomPurpose::Motion);

TEST(PersonMotion, MovesByVelocityWithoutNoise) {
  Eigen::ArrayXXd states(1, 8);
  states << 1.0, 2.0, 3.0, 0.5, -1.0, 2.0, 0.3, 0.4;
  PersonMotion motion{0.1, 0.0, 0.0, 0.0};
  motion.predict(states, 0, kStream);
  Eigen::ArrayXXd expected(1, 8);
  expected << 1.05, 1.9, 3.2, 0.5, -1.0, 2.0, 0.3, 0.4; // equation 15 with dt = 0.1 s
  EXPECT_LT((states - expected).abs().maxCoeff(), 1e-12);
}

TEST(PersonMotion, NoiseHasTheDeclaredDeviations) {
  Eigen::ArrayXXd states = Eigen::ArrayXXd::Zero(20000, 8);
  states.col(6) = 0.5;
  states.col(7) = 0.5;
  PersonMotion{0.1, 0.03, 0.25, 0.01}.predict(states, 0, kStream);
  const auto deviation = [&](int column) {
    const Eigen::ArrayXd centered = states.col(column) - states.col(column).mean();
    return std::sqrt(centered.square().mean());
  };
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(deviation(axis), 0.03, 0.001);
    EXPECT_NEAR(deviation(axis + 3), 0.25, 0.008);
  }
  EXPECT_NEAR(deviation(6), 0.01, 0.0003);
  EXPECT_NEAR(deviation(7), 0.01, 0.0003);
}

TEST(PersonMotion, HueGoesRound) {
  Eigen::ArrayXXd states = Eigen::ArrayXXd::Zero(100, 8); // hue 0: half of them fall below
  PersonMotion{0.1, 0.0, 0.0, 0.02}.predict(states, 0, kStream);
  EXPECT_GE(states.col(6).minCoeff(), 0.0);
  EXPECT_LT(states.col(6).maxCoeff(), 1.0);
  EXPECT_GT(states.col(6).maxCoeff(), 0.9);
  EXPECT_GE(states.col(7).minCoeff(), 0.0);
}

TEST(WalkingMotion, DoesNotDependOnHowTheSetIsCut) {
  Eigen::ArrayXXd whole = Eigen::ArrayXXd::Constant(10, 5, 1.0);
  Eigen::ArrayXXd cut = whole;
  const WalkingMotion motion{0.05, 3.0, 1.7, 0.01};
  motion.predict(whole, 0, kStream);
  motion.predict(cut.topRows(4), 0, kStream);
  motion.predict(cut.bottomRows(6), 4, kStream);
  EXPECT_TRUE((whole == cut).all());
}

} // namespace
} // namespace dewpoint::tests
