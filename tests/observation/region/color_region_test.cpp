// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/region/color_region.h"
#include "tests/observation/drawn_ellipsoids.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace dewpoint::tests {
namespace {

using drawn::kRedPaint;
using drawn::kSomethingNew;
using drawn::RegionScene;

LabelImage& firstLabels(RegionScene& scene) {
  return scene.observation().views()[0].labels;
}

// A rectangle of w x h pixels has the second moments w² / 12 and h² / 12 along its sides.
TEST(ColorRegion, HasTheMomentsOfARectangle) {
  RegionScene scene(drawn::rigAround(1));
  cv::rectangle(scene.image(0), cv::Rect(100, 50, 40, 20), kRedPaint, cv::FILLED);
  const auto regions = findRegions(firstLabels(scene), {80, 30, 100, 100}, 4.0);
  ASSERT_EQ(regions.size(), 1U);
  const ColorRegion& region = regions[0];
  EXPECT_EQ(region.area, 800.0);
  EXPECT_LT((region.centroid - Eigen::Vector2d(119.5, 59.5)).norm(), 1e-9);
  EXPECT_NEAR(region.covariance(0, 0), 1600.0 / 12.0, 1e-9);
  EXPECT_NEAR(region.covariance(1, 1), 400.0 / 12.0, 1e-9);
  EXPECT_NEAR(region.covariance(0, 1), 0.0, 1e-9);
  EXPECT_EQ(region.box, cv::Rect(100, 50, 40, 20));
  EXPECT_EQ(region.rimPixelCount, 2 * 40 + 2 * 18);
  EXPECT_EQ(region.cutOffShare(), 0.0);
}

TEST(ColorRegion, JoinsPiecesThatAreNearAndLeavesNoiseOut) {
  RegionScene scene(drawn::rigAround(1));
  cv::rectangle(scene.image(0), cv::Rect(100, 50, 20, 10), kRedPaint, cv::FILLED);
  cv::rectangle(scene.image(0), cv::Rect(123, 50, 20, 10), kRedPaint, cv::FILLED); // 3 px apart
  cv::rectangle(scene.image(0), cv::Rect(160, 50, 10, 10), kRedPaint, cv::FILLED);
  cv::rectangle(scene.image(0), cv::Rect(200, 90, 1, 2), kRedPaint, cv::FILLED);
  const auto regions = findRegions(firstLabels(scene), {0, 0, 320, 240}, 4.0);
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_EQ(regions[0].area, 400.0);
  EXPECT_EQ(regions[1].area, 100.0);
}

// Of the two halves of a rectangle the moments are those of the whole.
TEST(ColorRegion, JoinedMomentsAreThoseOfTheWhole) {
  RegionScene scene(drawn::rigAround(1));
  cv::rectangle(scene.image(0), cv::Rect(100, 50, 40, 20), kRedPaint, cv::FILLED);
  const auto left = findRegions(firstLabels(scene), {90, 30, 30, 100}, 4.0);
  const auto right = findRegions(firstLabels(scene), {120, 30, 30, 100}, 4.0);
  const auto whole = findRegions(firstLabels(scene), {90, 30, 60, 100}, 4.0);
  ASSERT_TRUE(left.size() == 1U && right.size() == 1U && whole.size() == 1U);
  const ColorRegion both = joined(left[0], right[0]);
  EXPECT_EQ(both.area, whole[0].area);
  EXPECT_LT((both.centroid - whole[0].centroid).norm(), 1e-9);
  // Each half counts the width of its pixels once, as the whole does.
  EXPECT_LT((both.covariance - whole[0].covariance).norm(), 1e-9);
  EXPECT_EQ(both.box, whole[0].box);
}

TEST(ColorRegion, KnowsWhereItsRimIsNotItsOwn) {
  RegionScene scene(drawn::rigAround(1));
  cv::rectangle(scene.image(0), cv::Rect(0, 50, 20, 20), kRedPaint, cv::FILLED);
  cv::rectangle(scene.image(0), cv::Rect(200, 50, 20, 20), kRedPaint, cv::FILLED);
  cv::rectangle(scene.image(0), cv::Rect(220, 50, 20, 20), kSomethingNew, cv::FILLED);
  const auto regions = findRegions(firstLabels(scene), {0, 0, 320, 240}, 4.0);
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_EQ(regions[0].cutRimPixelCount, 20);
  EXPECT_EQ(regions[0].hiddenRimPixelCount, 0);
  EXPECT_EQ(regions[1].cutRimPixelCount, 0);
  EXPECT_EQ(regions[1].hiddenRimPixelCount, 20);
  EXPECT_NEAR(regions[1].cutOffShare(), 20.0 / (4 * 19), 1e-9);
}

} // namespace
} // namespace dewpoint::tests
