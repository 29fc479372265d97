// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera_motion/agreement/color_regions.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <numbers>

namespace dewpoint::tests {
namespace {

const ColorRange kRed{340.0, 20.0, 0.5, 1.0, 0.1, 0.9};
const cv::Scalar kRedBgr(30, 30, 220);

cv::Mat grayWall() {
  return {240, 320, CV_8UC3, cv::Scalar::all(100)};
}

TEST(ColorRegions, TheCenterOfADiscIsKnownToLessThanAPixel) {
  cv::Mat image = grayWall();
  cv::circle(image, {120, 80}, 15, kRedBgr, cv::FILLED);
  const auto regions = ColorRegionSearch(kRed).find(image);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_NEAR(regions[0].center.x(), 120.0, 0.3);
  EXPECT_NEAR(regions[0].center.y(), 80.0, 0.6); // every other row was looked at
  EXPECT_NEAR(regions[0].radius, 15.0, 0.7);
  EXPECT_LT(regions[0].sigma, 2.0);
}

// The centroid of half a disc is 4 / (3 pi) = 0.42 radii from the middle of the whole one.
TEST(ColorRegions, OfHalfADiscTheCenterIsUncertainByWhatItIsOff) {
  cv::Mat image = grayWall();
  cv::circle(image, {120, 80}, 20, kRedBgr, cv::FILLED);
  image(cv::Rect(120, 0, 200, 240)) = cv::Scalar::all(100);
  const auto regions = ColorRegionSearch(kRed).find(image);
  ASSERT_EQ(regions.size(), 1U);
  const double off = 20.0 * 4.0 / (3.0 * std::numbers::pi);
  EXPECT_NEAR(120.0 - regions[0].center.x(), off, 0.7);
  EXPECT_GT(regions[0].sigma, 0.6 * off);
}

TEST(ColorRegions, WhatTheBorderCutsIsUncertainByItsSize) {
  cv::Mat image = grayWall();
  cv::circle(image, {0, 120}, 20, kRedBgr, cv::FILLED);
  const auto regions = ColorRegionSearch(kRed).find(image);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_GE(regions[0].sigma, regions[0].radius);
}

TEST(ColorRegions, ABallWithAStripeIsOneAndTwoBallsAreTwo) {
  cv::Mat image = grayWall();
  cv::circle(image, {80, 80}, 15, kRedBgr, cv::FILLED);
  image(cv::Rect(78, 0, 5, 240)) = cv::Scalar::all(100);
  cv::circle(image, {220, 150}, 10, kRedBgr, cv::FILLED);
  const auto regions = ColorRegionSearch(kRed).find(image);
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_NEAR(regions[0].center.x(), 80.0, 1.0); // the largest first
  EXPECT_NEAR(regions[1].center.x(), 220.0, 1.0);
}

TEST(ColorRegions, SpecksAndOtherImagesHaveNone) {
  cv::Mat image = grayWall();
  image.at<cv::Vec3b>(50, 50) = {30, 30, 220};
  image(cv::Rect(100, 100, 3, 3)) = kRedBgr;
  ColorRegionSearch search(kRed);
  EXPECT_TRUE(search.find(image).empty());
  EXPECT_TRUE(search.find(cv::Mat(240, 320, CV_8UC1, cv::Scalar(0))).empty());
}

} // namespace
} // namespace dewpoint::tests
