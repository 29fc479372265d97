// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/track/shape_belief.h"
#include "tests/observation/drawn_ellipsoids.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

using drawn::kFrame;
using drawn::kRadius;
using drawn::kVga;
using drawn::RegionScene;

Target target(double radius, TargetShape shape = TargetShape::Auto) {
  Target result;
  result.radius = radius;
  result.shape = shape;
  return result;
}

/// Shows a solid to a belief for some frames, in which a ball of a radius was found; 0: of its own.
void look(ShapeBelief& belief, const Ellipsoid& solid, int frames, double radius = 0.0) {
  RegionScene scene(drawn::rigAround(2, kVga));
  scene.show({solid});
  RegionObservation& observation = scene.observation();
  std::vector<RegionMeasurement> views;
  for (auto& view : observation.views()) {
    views.push_back(
        measureRegion(view.labels, *view.projector.project(solid), Eigen::Matrix2d::Zero()));
  }
  for (int frame = 0; frame < frames; ++frame) {
    belief.learn(observation, views, solid.center, radius > 0.0 ? radius : solid.radius(), kFrame);
  }
}

const Ellipsoid kRoundBall = drawn::ellipsoid(drawn::kMiddle, {kRadius, kRadius, kRadius});
const Ellipsoid kStick = drawn::ellipsoid(drawn::kMiddle, {0.12, 0.015, 0.015}, 0.4);

// One look may be spoiled by something that touches a ball; a quarter of a second may not.
TEST(ShapeBelief, AFewLooksTellAStickFromABallOfUnknownSize) {
  ShapeBelief belief(target(0.0));
  EXPECT_TRUE(belief.isBall());
  look(belief, kStick, 1);
  EXPECT_TRUE(belief.isBall());
  look(belief, kStick, 8);
  EXPECT_FALSE(belief.isBall());
  ShapeBelief other(target(0.0));
  look(other, kRoundBall, 1);
  EXPECT_TRUE(other.isBall());
}

// A small ball found in a large thing is refuted at once: other balls were looked at before.
TEST(ShapeBelief, ABallOfAnotherSizeIsLookedAtAnew) {
  ShapeBelief belief(target(0.0));
  look(belief, kStick, 1);
  ASSERT_TRUE(belief.isBall());
  look(belief, kStick, 1, 0.004);
  EXPECT_FALSE(belief.isBall());
}

// What follows within half a second is hardly new, and a belief that is 15 at most takes 17 and
// more of 5 at most each half second to change: three seconds and a half.
TEST(ShapeBelief, ChangesWithinSeconds) {
  ShapeBelief belief(target(0.0));
  look(belief, kRoundBall, 300);
  EXPECT_FALSE(belief.isUnclear());
  look(belief, kStick, 15);
  EXPECT_TRUE(belief.isBall());
  look(belief, kStick, 150);
  EXPECT_FALSE(belief.isBall());
}

// A radius that was given says that it is a ball: what is much larger is not the target alone.
TEST(ShapeBelief, AGivenRadiusIsThatOfABall) {
  ShapeBelief belief(target(kRadius));
  look(belief, drawn::ellipsoid(drawn::kMiddle, {0.2, 0.1, 0.1}), 100);
  EXPECT_TRUE(belief.isBall());
  // Two that touch are not, either.
  look(belief, drawn::ellipsoid(drawn::kMiddle, {2.0 * kRadius, kRadius, kRadius}), 100);
  EXPECT_TRUE(belief.isBall());
  // What is of the right size is believed after log odds of 30 and 2, at most 5 at the first look
  // and 5 in each half second after it: 2.7 seconds.
  const Ellipsoid other = drawn::ellipsoid(drawn::kMiddle, {0.07, 0.02, 0.02});
  look(belief, other, 60);
  EXPECT_TRUE(belief.isBall());
  look(belief, other, 120);
  EXPECT_FALSE(belief.isBall());
}

TEST(ShapeBelief, DoesAsItWasDefined) {
  ShapeBelief ball(target(0.0, TargetShape::Ball));
  look(ball, kStick, 10);
  EXPECT_TRUE(ball.isBall());
  ShapeBelief any(target(0.0, TargetShape::Any));
  look(any, kRoundBall, 10);
  EXPECT_FALSE(any.isBall());
  any.setTarget(target(0.0, TargetShape::Ball));
  EXPECT_TRUE(any.isBall());
}

} // namespace
} // namespace dewpoint::tests
