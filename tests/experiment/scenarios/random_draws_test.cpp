// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/color_range.h"
#include "core/experiment/scenarios/grade.h"
#include "core/experiment/scenarios/pink_target.h"
#include "core/experiment/scenarios/random_draws.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dewpoint::tests {
namespace {

TEST(RandomDraws, TheSameSeedAndNameGiveTheSameNumbers) {
  RandomDraws one(11, "S4");
  RandomDraws same(11, "S4");
  RandomDraws otherSeed(12, "S4");
  RandomDraws otherName(11, "S5");
  const double first = one.drawUniform(0.0, 1.0);
  EXPECT_EQ(same.drawUniform(0.0, 1.0), first);
  EXPECT_NE(otherSeed.drawUniform(0.0, 1.0), first);
  EXPECT_NE(otherName.drawUniform(0.0, 1.0), first);
  EXPECT_NE(one.drawUniform(0.0, 1.0), first) << "each number is drawn anew";
}

// 4000 draws: the mean of a uniform number is off by 0.0046 (one standard error), the standard
// deviation of a normal one by 1.1 %, a share of one third by 0.0075. Four of each are allowed.
TEST(RandomDraws, NumbersAreDistributedAsTheyAreCalled) {
  constexpr int kDraws = 4000;
  RandomDraws draws(3, "distribution");
  double sum = 0.0;
  double squares = 0.0;
  int lowest = 0;
  int heads = 0;
  Eigen::Vector3d directions = Eigen::Vector3d::Zero();
  for (int k = 0; k < kDraws; ++k) {
    const double number = draws.drawUniform(2.0, 3.0);
    EXPECT_GE(number, 2.0);
    EXPECT_LE(number, 3.0);
    sum += number;
    squares += std::pow(draws.drawNormal(0.5), 2);
    const int whole = draws.drawInteger(4, 6);
    EXPECT_GE(whole, 4);
    EXPECT_LE(whole, 6);
    lowest += whole == 4 ? 1 : 0;
    heads += draws.flipCoin() ? 1 : 0;
    const Eigen::Vector3d direction = draws.drawDirection();
    EXPECT_NEAR(direction.norm(), 1.0, 1e-12);
    directions += direction;
    const Eigen::Vector3d inside = draws.drawPointInBox({0.0, -1.0, 2.0}, {1.0, 0.0, 2.0});
    EXPECT_TRUE(inside.y() >= -1.0 && inside.y() <= 0.0 && inside.z() == 2.0);
  }
  EXPECT_NEAR(sum / kDraws, 2.5, 0.0184);
  EXPECT_NEAR(std::sqrt(squares / kDraws), 0.5, 0.0224);
  EXPECT_NEAR(lowest / double(kDraws), 1.0 / 3.0, 0.03);
  EXPECT_NEAR(heads / double(kDraws), 0.5, 0.0316);
  EXPECT_LT((directions / kDraws).norm(), 0.04) << "no direction is preferred";
}

TEST(RandomDraws, TheHashOfATextIsTheSameEverywhere) {
  // FNV-1a with 32 bits: reference values of its authors.
  EXPECT_EQ(hashOf(""), 0x811c9dc5U);
  EXPECT_EQ(hashOf("a"), 0xe40c292cU);
  EXPECT_EQ(hashOf("foobar"), 0xbf9cf968U);
}

TEST(Grade, NamesGoThereAndBack) {
  for (const Grade grade : {Grade::Ideal, Grade::Room, Grade::Wild, Grade::Real}) {
    EXPECT_EQ(gradeFromName(gradeName(grade)), grade);
  }
  EXPECT_FALSE(gradeFromName("both"));
  EXPECT_FALSE(gradeFromName(""));
}

TEST(PinkTarget, HasAUsableColor) {
  const Target target = scenarios::pinkTarget("ball", 0.035);
  EXPECT_EQ(target.name, "ball");
  EXPECT_EQ(target.radius, 0.035);
  EXPECT_TRUE(checkColorRange(target.color));
}

} // namespace
} // namespace dewpoint::tests
