// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/baselines/baseline_kalman.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

const Eigen::Matrix3d kSmall = 1e-6 * Eigen::Matrix3d::Identity(); // 1 mm

TEST(PositionKalmanFilter, FirstUpdateByHand) {
  // Start at 0 with variance 1, speed variance 1, no acceleration. After 1 s: variance 2,
  // covariance with the speed 1. A measurement 3 of variance 1: gain 2/3 and 1/3, so position 2,
  // speed 1, variance (1 - 2/3) * 2 = 2/3.
  PositionKalmanFilter point({0.0, 1.0, 16.266, 3, 10.0});
  point.update(Eigen::Vector3d::Zero(), Eigen::Matrix3d::Identity());
  point.predict(1.0);
  point.update({3, 0, 0}, Eigen::Matrix3d::Identity());
  EXPECT_LT((point.position() - Eigen::Vector3d(2, 0, 0)).norm(), 1e-12);
  EXPECT_LT((point.velocity() - Eigen::Vector3d(1, 0, 0)).norm(), 1e-12);
  EXPECT_LT((point.covariance() - 2.0 / 3.0 * Eigen::Matrix3d::Identity()).norm(), 1e-12);
}

TEST(PositionKalmanFilter, PredictsThroughGapsAndThenForgets) {
  PositionKalmanFilter point;
  EXPECT_FALSE(point.isStarted());
  for (int k = 0; k < 30; ++k) { // 1 m/s along x, at 30 frames/s
    point.predict(1.0 / 30.0);
    point.update({k / 30.0, 0, 0}, kSmall);
  }
  for (int k = 30; k < 44; ++k) { // the 14 frames up to 0.47 s are within the half second
    point.predict(1.0 / 30.0);
  }
  ASSERT_TRUE(point.isStarted());
  EXPECT_NEAR(point.position().x(), 43.0 / 30.0, 0.01);
  point.predict(1.0 / 15.0); // 0.53 s
  EXPECT_FALSE(point.isStarted());
}

TEST(PositionKalmanFilter, RefusesOutliersButBelievesTheThird) {
  PositionKalmanFilter point;
  for (int k = 0; k < 30; ++k) {
    point.predict(1.0 / 30.0);
    point.update(Eigen::Vector3d::Zero(), kSmall);
  }
  const Eigen::Vector3d elsewhere(0.5, 0, 0);
  for (int k = 0; k < 2; ++k) {
    point.predict(1.0 / 30.0);
    point.update(elsewhere, kSmall);
    EXPECT_LT(point.position().norm(), 0.01);
  }
  point.predict(1.0 / 30.0);
  point.update(elsewhere, kSmall);
  EXPECT_EQ(point.position(), elsewhere);
}

} // namespace
} // namespace dewpoint::tests
