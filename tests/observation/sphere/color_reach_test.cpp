// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/color_classifier.h"
#include "core/color/match_image.h"
#include "core/observation/sphere/color_reach.h"
#include "tests/observation/drawn_spheres.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <cmath>

namespace dewpoint::tests {
namespace {

const ColorRange kPinkRange{310.0, 350.0, 0.3, 0.9, 0.25, 0.8};
const cv::Scalar kPinkBall(140.0, 60.0, 220.0); // hue 330, saturation 0.57, intensity 0.55
const cv::Point kDiscCenter(100, 70);
constexpr int kDiscRadius = 30;

/// A pink ball on a gray wall, whose brightness falls from left to right by the factor `darkest`.
cv::Mat sideLit(double darkest, const cv::Scalar& ball = kPinkBall) {
  cv::Mat image(160, 240, CV_8UC3, cv::Scalar(150, 150, 150));
  for (int row = 0; row < image.rows; ++row) {
    for (int column = 0; column < image.cols; ++column) {
      const double x = (column - kDiscCenter.x) / static_cast<double>(kDiscRadius);
      const double y = (row - kDiscCenter.y) / static_cast<double>(kDiscRadius);
      if (x * x + y * y <= 1.0) {
        const double gain = std::pow(darkest, 0.5 * (x + 1.0));
        image.at<cv::Vec3b>(row, column) = {cv::saturate_cast<std::uint8_t>(gain * ball[0]),
                                            cv::saturate_cast<std::uint8_t>(gain * ball[1]),
                                            cv::saturate_cast<std::uint8_t>(gain * ball[2])};
      }
    }
  }
  drawn::addNoise(image, 2.0, 5);
  return image;
}

/// Share of the disc that a range takes in.
double takenBy(const ColorRange& range, const cv::Mat& image) {
  cv::Mat disc = cv::Mat::zeros(image.size(), CV_8UC1);
  cv::circle(disc, kDiscCenter, kDiscRadius - 2, cv::Scalar(255), cv::FILLED);
  return double(cv::countNonZero(matchImage(image, ColorClassifier(range)) & disc)) /
         cv::countNonZero(disc);
}

TEST(ColorReach, TakesInTheShadedSide) {
  const cv::Mat image = sideLit(0.2);
  EXPECT_LT(takenBy(kPinkRange, image), 0.65);
  EXPECT_GT(takenBy(extendRangeToLight(kPinkRange, image), image), 0.95);
}

TEST(ColorReach, StaysWhereTheRangeFitsAlready) {
  EXPECT_EQ(extendRangeToLight(kPinkRange, sideLit(0.8)), kPinkRange);
}

TEST(ColorReach, FollowsAShiftedHue) {
  // Hue 347 at the bright side: within the range just so.
  const cv::Scalar redder(95.0, 60.0, 220.0);
  const cv::Mat image = sideLit(0.25, redder);
  EXPECT_LT(takenBy(kPinkRange, image), 0.9);
  EXPECT_GT(takenBy(extendRangeToLight(kPinkRange, image), image), 0.95);
}

TEST(ColorReach, NeverNarrowsTheRange) {
  ColorRange pale = kPinkRange;
  pale.saturationMin = 0.0;
  const ColorRange reached = extendRangeToLight(pale, sideLit(0.2));
  EXPECT_EQ(reached.saturationMin, 0.0);
  EXPECT_LT(reached.intensityMin, pale.intensityMin);
}

// A dark wall of the target's hue: taking in the shaded side would take in the wall.
TEST(ColorReach, DoesNotTakeInAWallOfTheColor) {
  cv::Mat image = sideLit(0.2);
  for (int row = 0; row < image.rows; ++row) {
    for (int column = 0; column < image.cols; ++column) {
      cv::Vec3b& pixel = image.at<cv::Vec3b>(row, column);
      if (std::abs(pixel[0] - 150) < 20 && std::abs(pixel[1] - 150) < 20) {
        pixel = {28, 12, 44};
      }
    }
  }
  const cv::Mat match = matchImage(image, ColorClassifier(extendRangeToLight(kPinkRange, image)));
  EXPECT_LT(cv::countNonZero(match), static_cast<int>(3.2 * kDiscRadius * kDiscRadius));
}

TEST(ColorReach, KeepsARangeThatMatchesNothingAndOneOfEveryHue) {
  const cv::Mat empty(160, 240, CV_8UC3, cv::Scalar(150, 150, 150));
  EXPECT_EQ(extendRangeToLight(kPinkRange, empty), kPinkRange);
  const ColorRange gray{0.0, 360.0, 0.0, 0.2, 0.3, 0.8};
  EXPECT_EQ(extendRangeToLight(gray, sideLit(0.2)), gray);
  EXPECT_EQ(extendRangeToLight(kPinkRange, cv::Mat()), kPinkRange);
}

} // namespace
} // namespace dewpoint::tests
