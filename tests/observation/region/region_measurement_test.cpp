// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/region/region_measurement.h"
#include "tests/observation/drawn_ellipsoids.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace dewpoint::tests {
namespace {

using drawn::kRedPaint;
using drawn::kSomethingNew;
using drawn::RegionScene;

const Eigen::Matrix2d kExact = Eigen::Matrix2d::Zero();

/// An upright ellipse.
EllipseImage ellipse(double x, double y, double a, double b) {
  return {{x, y}, Eigen::Vector2d(a * a, b * b).asDiagonal().toDenseMatrix()};
}

void paintEllipse(RegionScene& scene, double x, double y, int a, int b, const cv::Scalar& color) {
  cv::ellipse(scene.image(0), cv::Point2d(x, y), {a, b}, 0.0, 0.0, 360.0, color, cv::FILLED);
}

RegionMeasurement measured(RegionScene& scene, const EllipseImage& expected) {
  return measureRegion(scene.observation().views()[0].labels, expected, kExact);
}

TEST(RegionMeasurement, SeesAllOfWhatIsAsExpected) {
  RegionScene scene(drawn::rigAround(1));
  paintEllipse(scene, 150, 120, 40, 20, kRedPaint);
  const RegionMeasurement result = measured(scene, ellipse(150, 120, 40, 20));
  EXPECT_TRUE(result.isInView);
  ASSERT_TRUE(result.region);
  EXPECT_GT(result.visibleShare, 0.98);
  EXPECT_GT(result.matchedShare, 0.98);
  EXPECT_EQ(result.ringMatchShare, 0.0);
  EXPECT_LT((result.center() - Eigen::Vector2d(150, 120)).norm(), 0.1);
  EXPECT_GT(regionEvidence(result, 1.0), 0.9 * fullRegionEvidence());
}

// A region goes on outside the first window; another one beside it does not belong to it.
TEST(RegionMeasurement, FollowsARegionAsFarAsItGoes) {
  RegionScene scene(drawn::rigAround(1));
  cv::rectangle(scene.image(0), cv::Rect(20, 110, 240, 20), kRedPaint, cv::FILLED);
  paintEllipse(scene, 140, 60, 10, 10, kRedPaint);
  const RegionMeasurement result = measured(scene, ellipse(140, 120, 10, 10));
  ASSERT_TRUE(result.region);
  EXPECT_EQ(result.region->area, 4800.0);
}

TEST(RegionMeasurement, ComparesTheVisiblePartOfWhatIsCut) {
  RegionScene scene(drawn::rigAround(1));
  // Half of it is to the left of the image.
  paintEllipse(scene, 0, 120, 40, 40, kRedPaint);
  const RegionMeasurement result = measured(scene, ellipse(0, 120, 40, 40));
  ASSERT_TRUE(result.region);
  EXPECT_NEAR(result.visibleShare, 0.5, 0.02);
  EXPECT_GT(result.region->centroid.x(), 16.0); // 4 r / (3 pi) = 17
  EXPECT_LT((result.center() - Eigen::Vector2d(0, 120)).norm(), 0.5);
}

TEST(RegionMeasurement, WhatMayHideItSaysNothing) {
  RegionScene scene(drawn::rigAround(1));
  paintEllipse(scene, 150, 120, 60, 60, kSomethingNew);
  const RegionMeasurement hidden = measured(scene, ellipse(150, 120, 40, 20));
  EXPECT_FALSE(hidden.region);
  EXPECT_NEAR(regionEvidence(hidden, 1.0), 0.0, 0.5);
  RegionScene empty(drawn::rigAround(1));
  const RegionMeasurement gone = measured(empty, ellipse(150, 120, 40, 20));
  EXPECT_LT(regionEvidence(gone, 1.0), -0.7 * fullRegionEvidence());
}

// A wall of the color is no target.
TEST(RegionMeasurement, ColorAllAroundSpeaksAgainstIt) {
  RegionScene scene(drawn::rigAround(1));
  cv::rectangle(scene.image(0), cv::Rect(0, 0, 320, 240), kRedPaint, cv::FILLED);
  const RegionMeasurement result = measured(scene, ellipse(150, 120, 40, 20));
  EXPECT_LE(regionEvidence(result, 1.0), 0.01 * fullRegionEvidence());
}

} // namespace
} // namespace dewpoint::tests
