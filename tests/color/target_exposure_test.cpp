// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/target_exposure.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace dewpoint::tests {
namespace {

/// Ten pixels in one row: so many clipped in one channel, so many nearly black, the rest orange.
cv::Mat tenPixels(int clipped, int dark) {
  cv::Mat image(1, 10, CV_8UC3, cv::Scalar(30, 120, 200));
  for (int k = 0; k < clipped; ++k) {
    image.at<cv::Vec3b>(0, k) = {10, 90, 255};
  }
  for (int k = clipped; k < clipped + dark; ++k) {
    image.at<cv::Vec3b>(0, k) = {0, 19, 5};
  }
  return image;
}

TargetExposure exposureOfAll(const cv::Mat& image) {
  return exposureOf(image, cv::Mat(image.size(), CV_8UC1, cv::Scalar(255)));
}

TEST(TargetExposure, OneClippedChannelIsEnough) {
  const TargetExposure exposure = exposureOfAll(tenPixels(4, 0));
  EXPECT_EQ(exposure.pixelCount, 10);
  EXPECT_DOUBLE_EQ(exposure.clippedShare(), 0.4);
  EXPECT_DOUBLE_EQ(exposure.darkShare(), 0.0);
  EXPECT_EQ(exposure.fault(), ExposureFault::Overexposed);
}

TEST(TargetExposure, APixelIsDarkOnlyIfAllItsChannelsAre) {
  EXPECT_EQ(exposureOfAll(tenPixels(0, 6)).fault(), ExposureFault::TooDark);
  EXPECT_DOUBLE_EQ(exposureOfAll(tenPixels(0, 6)).darkShare(), 0.6);
  const cv::Mat bluish(1, 1, CV_8UC3, cv::Scalar(20, 0, 0));
  EXPECT_EQ(exposureOfAll(bluish).darkCount, 0);
}

TEST(TargetExposure, HighlightsAndShadowsAreNoFault) {
  EXPECT_EQ(exposureOfAll(tenPixels(1, 4)).fault(), ExposureFault::None);
  EXPECT_EQ(exposureOfAll(tenPixels(2, 0)).fault(), ExposureFault::Overexposed);
  EXPECT_EQ(exposureOfAll(tenPixels(0, 5)).fault(), ExposureFault::TooDark);
  EXPECT_EQ(exposureOfAll(tenPixels(3, 6)).fault(), ExposureFault::Overexposed); // the worse one
}

TEST(TargetExposure, OnlyPixelsInTheMaskCount) {
  cv::Mat mask(1, 10, CV_8UC1, cv::Scalar(0));
  mask.at<std::uint8_t>(0, 0) = 1;
  mask.at<std::uint8_t>(0, 9) = 255;
  const TargetExposure exposure = exposureOf(tenPixels(4, 0), mask);
  EXPECT_EQ(exposure.pixelCount, 2);
  EXPECT_EQ(exposure.clippedCount, 1);
}

TEST(TargetExposure, TheHistogramHasEachPixelByItsLargestChannel) {
  const TargetExposure exposure = exposureOfAll(tenPixels(4, 3));
  EXPECT_EQ(exposure.histogram[31], 4); // 248 to 255
  EXPECT_EQ(exposure.histogram[2], 3);  // 16 to 23
  EXPECT_EQ(exposure.histogram[25], 3); // 200 to 207
}

TEST(TargetExposure, ColorsOfASampleGiveTheSame) {
  const std::vector<BgrColor> colors{{10, 90, 255}, {0, 19, 5}, {30, 120, 200}};
  const TargetExposure exposure = exposureOf(colors);
  EXPECT_EQ(exposure.pixelCount, 3);
  EXPECT_EQ(exposure.clippedCount, 1);
  EXPECT_EQ(exposure.darkCount, 1);
}

TEST(TargetExposure, NothingHasNoFault) {
  const TargetExposure exposure = exposureOf(std::vector<BgrColor>());
  EXPECT_EQ(exposure.clippedShare(), 0.0);
  EXPECT_EQ(exposure.darkShare(), 0.0);
  EXPECT_EQ(exposure.fault(), ExposureFault::None);
}

} // namespace
} // namespace dewpoint::tests
