// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/targets/hidden_share.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

using experiment::scenarios::hiddenShare;
using experiment::scenarios::overlappedFraction;
using simulation::MovingPart;

/// A plate square to X, 1 x 1 m, whose lower edge is at z = `low`.
MovingPart plateAt(float x, float low) {
  MovingPart plate;
  plate.shape = simulation::MovingShape::Box;
  plate.center = {x, 0.0F, low + 0.5F};
  plate.size = {0.001F, 0.5F, 0.5F};
  return plate;
}

TEST(HiddenShare, APlateWithItsEdgeOnTheLineOfSightHidesHalf) {
  const Eigen::Vector3d eye{0.0, 0.0, 0.0};
  const Eigen::Vector3d ball{1.0, 0.0, 0.0};
  EXPECT_NEAR(hiddenShare(eye, ball, 0.05, {plateAt(0.5F, 0.0F)}), 0.5, 0.02);
  EXPECT_EQ(hiddenShare(eye, ball, 0.05, {plateAt(0.5F, 0.03F)}), 0.0);
  EXPECT_EQ(hiddenShare(eye, ball, 0.05, {plateAt(0.5F, -0.5F)}), 1.0);
  // At half of the way, half a radius is a quarter of one: from there on a disc's segment of
  // height R / 2 is hidden, which is acos(1/2) - sqrt(3)/4 of pi: 0.196.
  EXPECT_NEAR(hiddenShare(eye, ball, 0.05, {plateAt(0.5F, 0.0125F)}), 0.196, 0.02);
}

TEST(HiddenShare, WhatIsBehindTheBallBacksItAndHidesNothing) {
  const Eigen::Vector3d eye{0.0, 0.0, 0.0};
  const Eigen::Vector3d ball{1.0, 0.0, 0.0};
  EXPECT_EQ(hiddenShare(eye, ball, 0.05, {plateAt(1.5F, 0.0F)}), 0.0);
  EXPECT_NEAR(overlappedFraction(eye, ball, 0.05, {plateAt(1.5F, 0.0F)}), 0.5, 0.02);
  EXPECT_EQ(overlappedFraction(eye, ball, 0.05, {plateAt(1.5F, -0.5F)}), 1.0);
  EXPECT_EQ(overlappedFraction(eye, ball, 0.05, {}), 0.0);
}

} // namespace
} // namespace dewpoint::tests
