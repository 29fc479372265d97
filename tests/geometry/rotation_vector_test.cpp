// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/rotation_vector.h"

#include <gtest/gtest.h>

#include <numbers>

namespace dewpoint::tests {
namespace {

// Rodrigues' formula by hand: a quarter turn about z takes x to y, and y to -x.
TEST(RotationVector, AQuarterTurnTakesOneAxisToTheNext) {
  const Eigen::Matrix3d rotation = rotationFromVector({0.0, 0.0, 0.5 * std::numbers::pi});
  Eigen::Matrix3d wanted;
  wanted << 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0;
  EXPECT_LT((rotation - wanted).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(RotationVector, NoLengthIsNoRotation) {
  EXPECT_EQ(rotationFromVector(Eigen::Vector3d::Zero()), Eigen::Matrix3d::Identity());
  EXPECT_EQ(vectorFromRotation(Eigen::Matrix3d::Identity()), Eigen::Vector3d::Zero());
}

// Beyond pi the same rotation has a shorter vector, in the opposite direction.
TEST(RotationVector, ComesBackWithinHalfATurn) {
  for (const Eigen::Vector3d& vector :
       {Eigen::Vector3d(0.3, -0.2, 0.1), Eigen::Vector3d(1e-6, 0.0, 0.0),
        Eigen::Vector3d(-1.0, 2.0, -2.0)}) {
    EXPECT_LT((vectorFromRotation(rotationFromVector(vector)) - vector).norm(), 1e-12);
  }
  const Eigen::Vector3d vector(0.0, 1.5 * std::numbers::pi, 0.0);
  const Eigen::Vector3d shorter(0.0, -0.5 * std::numbers::pi, 0.0);
  EXPECT_LT((vectorFromRotation(rotationFromVector(vector)) - shorter).norm(), 1e-12);
}

TEST(RotationVector, TheAngleBetweenTwoRotationsIsThatOfTheTurnFromOneToTheOther) {
  const Eigen::Matrix3d one = rotationFromVector({0.4, -1.0, 0.3});
  const Eigen::Vector3d turn(0.2, 0.1, -0.6);
  const Eigen::Matrix3d other = rotationFromVector(turn) * one;
  EXPECT_NEAR(angleBetween(one, other), turn.norm(), 1e-12);
  EXPECT_NEAR(angleBetween(other, one), turn.norm(), 1e-12);
  EXPECT_NEAR(angleBetween(one, one), 0.0, 1e-7);
  const Eigen::Matrix3d opposite =
      rotationFromVector(Eigen::Vector3d(0.0, 0.0, std::numbers::pi)) * one;
  EXPECT_NEAR(angleBetween(one, opposite), std::numbers::pi, 1e-7);
}

} // namespace
} // namespace dewpoint::tests
