// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/baselines/baseline_blobs.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <cmath>

namespace dewpoint::tests {
namespace {

TEST(FindBlobs, GivesCentersOfMassLargestFirst) {
  cv::Mat mask = cv::Mat::zeros(40, 60, CV_8UC1);
  mask(cv::Rect(10, 20, 2, 2)) = 255; // columns 10, 11 and rows 20, 21: center (10.5, 20.5)
  mask(cv::Rect(30, 5, 4, 3)) = 255;  // columns 30-33, rows 5-7: center (31.5, 6)
  mask(cv::Rect(50, 30, 3, 1)) = 255; // three pixels: noise
  const auto blobs = findBlobs(mask);
  ASSERT_EQ(blobs.size(), 2U);
  EXPECT_EQ(blobs[0].areaPx, 12);
  EXPECT_EQ(blobs[0].box, cv::Rect(30, 5, 4, 3));
  EXPECT_NEAR(blobs[0].radiusPx(), 1.954, 5e-4) << "sqrt(12 / pi)";
  EXPECT_LT((blobs[0].center - Eigen::Vector2d(31.5, 6.0)).norm(), 1e-12);
  EXPECT_EQ(blobs[1].areaPx, 4);
  EXPECT_LT((blobs[1].center - Eigen::Vector2d(10.5, 20.5)).norm(), 1e-12);
}

TEST(FindBlobs, JoinsDiagonalNeighborsAndOrdersEqualOnes) {
  cv::Mat mask = cv::Mat::zeros(20, 20, CV_8UC1);
  for (int k = 0; k < 4; ++k) {
    mask.at<std::uint8_t>(10 + k, 2 + k) = 255;
    mask.at<std::uint8_t>(1, 10 + k) = 255;
  }
  const auto blobs = findBlobs(mask);
  ASSERT_EQ(blobs.size(), 2U);
  EXPECT_LT((blobs[0].center - Eigen::Vector2d(11.5, 1.0)).norm(), 1e-12) << "the upper one first";
  EXPECT_LT((blobs[1].center - Eigen::Vector2d(3.5, 11.5)).norm(), 1e-12);
}

TEST(FindBlobs, FindsNothingInNothing) {
  EXPECT_TRUE(findBlobs(cv::Mat()).empty());
  EXPECT_TRUE(findBlobs(cv::Mat::zeros(10, 10, CV_8UC1)).empty());
}

/// A camera at `center` with focal length 100 px sees `point` exactly.
Bearing bearing(std::size_t camera, std::size_t blob, const Eigen::Vector3d& center,
                const Eigen::Vector3d& point) {
  return {camera, blob, {center, (point - center).normalized()}, 100.0};
}

TEST(Triangulate, StatesTheCovarianceOfItsGeometry) {
  // Two cameras 1 m from the origin, on x and y: each knows the two directions across its ray with
  // 0.5 px * 1 m / 100 px = 5 mm. So x and y come from one camera, z from two.
  const auto point =
      triangulate({bearing(0, 0, {1, 0, 0}, {0, 0, 0}), bearing(1, 0, {0, 1, 0}, {0, 0, 0})});
  ASSERT_TRUE(point.has_value());
  EXPECT_LT(point->position.norm(), 1e-12);
  EXPECT_LT(point->residualPx, 1e-9);
  const Eigen::Vector3d expected(25e-6, 25e-6, 12.5e-6);
  EXPECT_LT((point->covariance - Eigen::Matrix3d(expected.asDiagonal())).norm(), 1e-15);
}

TEST(Triangulate, StatesTheLargestResidualInPixels) {
  // Skew by 2 cm at 1 m, the point lies in the middle: 1 cm across, sqrt(1 + 0.01²) m away.
  const auto point = triangulate(
      {{0, 0, {{1, 0, 0.01}, {-1, 0, 0}}, 100.0}, {1, 0, {{0, 1, -0.01}, {0, -1, 0}}, 100.0}});
  ASSERT_TRUE(point.has_value());
  EXPECT_NEAR(point->residualPx, 100.0 * 0.01 / std::sqrt(1.0001), 1e-9);
}

} // namespace
} // namespace dewpoint::tests
