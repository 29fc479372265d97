// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/region/roundness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dewpoint::tests {
namespace {

EllipseImage circle(double radius) {
  return {Eigen::Vector2d::Zero(), radius * radius * Eigen::Matrix2d::Identity()};
}

/// Of a shape of this area with these second moments along its axes, seen whole.
ColorRegion region(double area, double xx, double yy) {
  ColorRegion result;
  result.area = area;
  result.covariance << xx, 0.0, 0.0, yy;
  result.rimPixelCount = 100;
  return result;
}

ColorRegion disc(double radius) {
  return region(std::numbers::pi * radius * radius, radius * radius / 4.0, radius * radius / 4.0);
}

TEST(Roundness, OfADiscIsZero) {
  const Roundness round = roundnessOf(disc(20.0), circle(5.0));
  EXPECT_NEAR(round.elongation, 0.0, 1e-6);
  EXPECT_NEAR(round.hollowness, 0.0, 1e-9);
}

// A rectangle of 4 x 1: its axes have the ratio 4, and it has 12 / (4 pi) of the ellipse's area.
TEST(Roundness, OfARectangle) {
  const Roundness round =
      roundnessOf(region(1600.0, 80.0 * 80.0 / 12.0, 20.0 * 20.0 / 12.0), circle(5.0));
  EXPECT_NEAR(round.elongation, std::log(4.0), 1e-9);
  EXPECT_NEAR(round.hollowness, 1.0 - 3.0 / std::numbers::pi, 1e-9);
}

// At the edge of a wide image a ball's outline is itself an ellipse.
TEST(Roundness, IsRelativeToTheOutlineOfABall) {
  EllipseImage wide;
  wide.extent << 4.0 * 25.0, 0.0, 0.0, 25.0;
  const Roundness round = roundnessOf(region(400.0 * std::numbers::pi * 2.0, 400.0, 100.0), wide);
  EXPECT_NEAR(round.elongation, 0.0, 1e-6);
}

TEST(Roundness, ADiscIsABallAndAStickIsNot) {
  const auto ball = shapeEvidence(disc(20.0), circle(20.0));
  const auto stick =
      shapeEvidence(region(1600.0, 80.0 * 80.0 / 12.0, 20.0 * 20.0 / 12.0), circle(20.0));
  ASSERT_TRUE(ball && stick);
  EXPECT_LT(*ball, -2.0);
  EXPECT_GT(*stick, 2.0);
}

// Two balls that touch have twice the area; a forearm in which a small ball was found has far more.
TEST(Roundness, ARegionFarLargerThanTheBallIsNone) {
  EXPECT_EQ(roundnessOf(disc(20.0), circle(20.0)).sizeExcess, 0.0);
  EXPECT_NEAR(roundnessOf(disc(20.0), circle(20.0 / std::sqrt(2.0))).sizeExcess, 0.0, 1e-9);
  EXPECT_NEAR(roundnessOf(disc(20.0), circle(5.0)).sizeExcess, std::log(4.0 / std::sqrt(2.0)),
              1e-9);
  const auto touching = shapeEvidence(disc(20.0), circle(20.0 / std::sqrt(2.0)));
  const auto small = shapeEvidence(disc(20.0), circle(5.0));
  ASSERT_TRUE(touching && small);
  EXPECT_LT(*touching, -2.0);
  EXPECT_GT(*small, *touching + 3.0);
  ColorRegion hidden = disc(20.0);
  hidden.hiddenRimPixelCount = 60;
  const auto partly = shapeEvidence(hidden, circle(5.0));
  ASSERT_TRUE(partly) << "what is hidden could only add to it";
  EXPECT_GT(*partly, 3.0);
}

TEST(Roundness, WhatIsNotSeenWholeSaysNothing) {
  ColorRegion hidden = disc(20.0);
  hidden.hiddenRimPixelCount = 30;
  EXPECT_FALSE(shapeEvidence(hidden, circle(20.0)));
  EXPECT_FALSE(shapeEvidence(disc(4.0), circle(4.0)));
}

} // namespace
} // namespace dewpoint::tests
