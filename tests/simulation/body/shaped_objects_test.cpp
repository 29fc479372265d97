// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/body/hand.h"
#include "core/simulation/body/shaped_objects.h"
#include "core/simulation/body/target_volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace dewpoint::tests {
namespace {

using simulation::MovingPart;
using simulation::Vector3f;

const Vector3f kPinkBody{145.0F, 85.0F, 245.0F};

TEST(ShapedObjects, WhatHasTheColorIsTheTarget) {
  for (const auto& parts :
       {simulation::capOnHead(kPinkBody), simulation::glovedHand(0.5, kPinkBody),
        simulation::sleevedArm(kPinkBody), simulation::cone(kPinkBody),
        simulation::stick(kPinkBody), simulation::computerMouse(kPinkBody)}) {
    EXPECT_TRUE(std::ranges::any_of(parts, &MovingPart::belongsToTarget));
    for (const MovingPart& part : parts) {
      EXPECT_EQ(part.belongsToTarget, part.color == kPinkBody);
    }
    EXPECT_LT(simulation::targetVolume(parts).centroid.norm(), 0.06) << "near the origin";
  }
}

TEST(ShapedObjects, AFistIsShorterThanAnOpenHand) {
  const auto open = simulation::partlyClosedHand(0.0, kPinkBody);
  const auto closed = simulation::partlyClosedHand(1.0, kPinkBody);
  ASSERT_EQ(open.size(), closed.size());
  const auto reach = [](const std::vector<MovingPart>& parts) {
    float most = 0.0F;
    for (const MovingPart& part : parts) {
      most = std::max(most, part.center.x() + part.size.z());
    }
    return most;
  };
  // Straight fingers end 0.043 + 0.095 m from the palm's middle; curled ones stay near the
  // knuckles.
  EXPECT_GT(reach(open), 0.12F);
  EXPECT_LT(reach(closed), 0.08F);
  // The parts are as large; a fist's overlap a little more.
  const double volume = simulation::targetVolume(open).volume;
  EXPECT_NEAR(simulation::targetVolume(closed).volume, volume, 0.2 * volume);
}

TEST(ShapedObjects, AGrippingHandTouchesTheBall) {
  simulation::Grip grip;
  const auto parts = simulation::grippingHand(grip, 0.035, simulation::kSkinColor);
  // Four fingers and a thumb of three parts, the palm and the forearm.
  ASSERT_EQ(parts.size(), 17U);
  for (std::size_t i = 0; i < 15; ++i) {
    // Joints are 35 + 9 mm from the ball's center; between them, up to 0.6 radians apart, a part's
    // middle is as near as cos 0.3 of that.
    EXPECT_LT(parts[i].center.norm(), 0.0441F);
    EXPECT_GT(parts[i].center.norm(), 0.044F * std::cos(0.3F));
  }
  EXPECT_GT(parts.back().center.dot(Vector3f::UnitX()), 0.05F)
      << "the forearm is on the palm's side";
}

TEST(ShapedObjects, AShirtIsTrunkAndArms) {
  simulation::Walker walker;
  walker.clothes.shirt = kPinkBody;
  walker.waypoints = {{0.0, {-1.0, 0.2}}, {2.0, {1.0, 0.2}}};
  const auto parts = simulation::shirtOnPerson(walker, 1.0);
  EXPECT_EQ(std::ranges::count_if(parts, &MovingPart::belongsToTarget), 5);
  const auto volume = simulation::targetVolume(parts);
  // Half way, around the middle of the trunk, 1.21 m high at a height of 1.75 m.
  EXPECT_NEAR(volume.centroid.x(), 0.0, 0.1);
  EXPECT_NEAR(volume.centroid.y(), 0.2, 0.05);
  EXPECT_NEAR(volume.centroid.z(), 1.21, 0.06);
}

} // namespace
} // namespace dewpoint::tests
