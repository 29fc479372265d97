// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/people/walker.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dewpoint::tests {
namespace {

using simulation::BodyPart;
using simulation::Posture;
using simulation::Walker;

/// Stands at the origin, and faces x.
Walker standingAtOrigin(double height) {
  Walker walker;
  walker.height = height;
  walker.waypoints = {{0.0, {0.0, 0.0}}};
  return walker;
}

Walker taking(Posture posture, double height = 1.75) {
  Walker walker = standingAtOrigin(height);
  walker.postures = {{1.0, posture}};
  return walker;
}

// The body that all scenes had before there were children and postures, which must not change: of
// 1.75 m its parts are as the source gives them.
TEST(Walker, AnAdultWhoStandsIsAsEver) {
  const auto parts = bodyParts(standingAtOrigin(1.75), 0.0);
  ASSERT_EQ(parts.size(), 12U); // head, hair, trunk, hips; per side thigh, shin, arm, forearm
  EXPECT_EQ(parts[0].center, simulation::Vector3f(0.0F, 0.0F, 1.61F));
  EXPECT_EQ(parts[0].halfSize, simulation::Vector3f(0.095F, 0.08F, 0.125F));
  EXPECT_EQ(parts[1].center, simulation::Vector3f(-0.02F, 0.0F, 1.655F));
  EXPECT_EQ(parts[1].halfSize, simulation::Vector3f(0.095F, 0.085F, 0.1F));
  EXPECT_EQ(parts[2].center, simulation::Vector3f(0.0F, 0.0F, 1.21F));
  EXPECT_EQ(parts[2].halfSize, simulation::Vector3f(0.125F, 0.195F, 0.29F));
  EXPECT_EQ(parts[3].center, simulation::Vector3f(0.0F, 0.0F, 0.93F));
  EXPECT_EQ(parts[3].halfSize, simulation::Vector3f(0.12F, 0.165F, 0.15F));
  // Thighs hang from 0.90 m and are 0.44 m long: their middle is at 0.68 m. Arms hang from 1.43 m.
  EXPECT_NEAR(parts[4].center.z(), 0.68F, 1e-6F);
  EXPECT_NEAR(parts[6].center.z(), 1.28F, 1e-6F);
  for (const BodyPart& part : parts) {
    EXPECT_TRUE(part.belongsToBody);
  }
}

TEST(Walker, HasAChildsHeadBelowAnAdultsHeight) {
  EXPECT_EQ(simulation::headHeightFraction(1.62), simulation::kAdultHeadHeightFraction);
  EXPECT_EQ(simulation::headHeightFraction(1.6), simulation::kAdultHeadHeightFraction);
  EXPECT_NEAR(simulation::headHeightFraction(0.9), 0.19, 1e-12);
  // Halfway between 0.9 and 1.6 m: the mean of 0.19 and 1/7.
  EXPECT_NEAR(simulation::headHeightFraction(1.25), 0.5 * (0.19 + 1.0 / 7.0), 1e-12);
  // Of 0.9 m, the head is 0.171 m high and the top of the hair where it is in an adult: 1.755
  // / 1.75 of the height.
  const auto parts = bodyParts(standingAtOrigin(0.9), 0.0);
  EXPECT_NEAR(2.0F * parts[0].halfSize.z(), 0.171F, 1e-5F);
  EXPECT_NEAR(parts[1].center.z() + parts[1].halfSize.z(), 0.9 * 1.755 / 1.75, 1e-5);
  // The trunk ends below the head: no more of it is covered than in an adult, 0.015 of 1.75 m.
  EXPECT_NEAR(parts[2].center.z() + parts[2].halfSize.z() -
                  (parts[0].center.z() - parts[0].halfSize.z()),
              0.015 * 0.9 / 1.75, 0.003);
}

TEST(Walker, IsAsTallAsItStands) {
  for (const double height : {0.9, 1.1, 1.75, 2.0}) {
    EXPECT_EQ(standingAtOrigin(height).topHeightAt(0.0), height);
  }
}

// Thighs at 1.5 rad, shins upright: the hips come down by 0.44 (1 - cos 1.5) = 0.409 m to 0.491 m.
// The hair's center, 0.755 m above them and 0.02 m behind, leans by 0.05 rad: it is at
// 0.491 + 0.755 cos 0.05 + 0.02 sin 0.05 = 1.246 m, the top at 1.346 m, that is 1.342 m of 1.75 m.
TEST(Walker, SitsLower) {
  const Walker sitter = taking(Posture::Sitting);
  EXPECT_EQ(sitter.topHeightAt(1.0), 1.75);
  EXPECT_NEAR(sitter.topHeightAt(2.0), 1.342, 0.001);
  const double between = sitter.topHeightAt(1.5);
  EXPECT_LT(between, 1.75);
  EXPECT_GT(between, sitter.topHeightAt(2.0));
  // The feet stay where they are: the lower end of the shins at 0.02 m less half their overhang.
  const auto parts = bodyParts(sitter, 2.0);
  EXPECT_NEAR(parts[5].center.z() - parts[5].halfSize.z(), -0.002F, 1e-4F);
  // A seat that fits is as high as the lower side of the thighs: 0.491 - 0.08 m.
  EXPECT_NEAR(simulation::seatHeight(1.75), 0.41, 0.002);
}

TEST(Walker, CrouchesLowerStillAndRises) {
  Walker walker = taking(Posture::Crouching);
  EXPECT_LT(walker.topHeightAt(2.0), 1.1);
  walker.postures.push_back({5.0, Posture::Standing});
  EXPECT_EQ(walker.topHeightAt(6.0), 1.75);
  const auto angles = jointAnglesAt(walker.postures, 6.0);
  EXPECT_TRUE(angles.isUpright());
}

// Halfway through a smooth change the share is 3/4 - 2/8 = 1/2.
TEST(Posture, ChangesSmoothly) {
  const std::vector<simulation::PostureChange> changes{{2.0, Posture::Sitting}};
  const auto sitting = jointAnglesOf(Posture::Sitting);
  EXPECT_EQ(jointAnglesAt(changes, 2.0).thigh, 0.0F);
  EXPECT_NEAR(jointAnglesAt(changes, 2.5).thigh, 0.5F * sitting.thigh, 1e-6F);
  EXPECT_EQ(jointAnglesAt(changes, 3.0).thigh, sitting.thigh);
  EXPECT_EQ(jointAnglesAt(changes, 9.0).lean, sitting.lean);
}

TEST(Walker, HoldsABoxBeforeTheChest) {
  Walker walker = standingAtOrigin(1.75);
  walker.carriedObject = simulation::CarriedObject();
  const auto parts = bodyParts(walker, 0.0);
  ASSERT_EQ(parts.size(), 13U);
  const BodyPart& box = parts.back();
  EXPECT_FALSE(box.belongsToBody);
  EXPECT_EQ(box.shape, simulation::PartShape::Box);
  // Half the trunk's depth, a gap of 0.01 m and half the box: 0.125 + 0.01 + 0.15 m ahead.
  EXPECT_NEAR(box.center.x(), 0.285F, 1e-5F);
  EXPECT_NEAR(box.center.y(), 0.0F, 1e-6F);
  EXPECT_EQ(walker.topHeightAt(0.0), 1.75);
}

TEST(Walker, CarriesABagBesideTheRightLeg) {
  Walker walker = standingAtOrigin(1.75);
  walker.carriedObject = simulation::CarriedObject();
  walker.carriedObject->kind = simulation::CarriedObject::Kind::Bag;
  const BodyPart bag = bodyParts(walker, 0.0).back();
  EXPECT_LT(bag.center.y(), -0.2F); // the walker faces x, so y is to the left
  EXPECT_LT(bag.center.z(), 0.9F);
}

TEST(Cloth, HasTwoColorsInStripes) {
  const simulation::Vector3f first(1.0F, 2.0F, 3.0F);
  simulation::Cloth cloth;
  cloth.secondColor = {7.0F, 8.0F, 9.0F};
  cloth.patternWidth = 0.1F;
  EXPECT_EQ(clothColor(cloth, first, {0.0F, 0.0F, 0.15F}), first); // plain
  cloth.pattern = simulation::ClothPattern::Stripes;
  EXPECT_EQ(clothColor(cloth, first, {0.0F, 0.0F, 0.05F}), first);
  EXPECT_EQ(clothColor(cloth, first, {0.3F, 0.2F, 0.15F}), cloth.secondColor);
  EXPECT_EQ(clothColor(cloth, first, {0.3F, 0.2F, -0.05F}), cloth.secondColor);
  cloth.pattern = simulation::ClothPattern::Checks;
  EXPECT_EQ(clothColor(cloth, first, {0.05F, 0.15F, 0.15F}), first); // fields 0 + 1 + 1
  EXPECT_EQ(clothColor(cloth, first, {0.05F, 0.05F, 0.15F}), cloth.secondColor);
}

} // namespace
} // namespace dewpoint::tests
