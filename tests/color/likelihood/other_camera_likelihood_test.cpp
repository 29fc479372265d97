// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/likelihood/other_camera_likelihood.h"
#include "tests/color/red_samples.h"

#include <gtest/gtest.h>
#include <opencv2/core/mat.hpp>

namespace dewpoint::tests {
namespace {

cv::Mat wallWithSquare(const cv::Rect& square, const cv::Scalar& bgr) {
  cv::Mat image(60, 80, CV_8UC3, cv::Scalar(120, 120, 120));
  image(square).setTo(bgr);
  return image;
}

cv::Mat everywhere(const cv::Mat& image) {
  return {image.size(), CV_8UC1, cv::Scalar(255)};
}

// 16 of 4800 pixels: what is rare in the image and of the target's color speaks for it, also a
// sixth more red and less blue, and a quarter darker; the wall and another color speak against it.
TEST(OtherCameraLikelihood, AllowsForWhiteBalanceAndExposure) {
  const cv::Mat image = wallWithSquare({10, 10, 4, 4}, {40, 40, 200});
  const color::ColorLikelihood table =
      color::OtherCameraLikelihood({kRed}).likelihoodForImage(image, everywhere(image));
  EXPECT_GT(nats(table, kRed), 1.0);
  EXPECT_GT(nats(table, {26, 30, 174}), 1.0);
  EXPECT_LT(nats(table, {120, 120, 120}), -1.0);
  EXPECT_LT(nats(table, {60, 160, 40}), 0.1);
}

// A quarter of the image is red: as part of all pixels it speaks against itself; as a region
// against all others it does not.
TEST(OtherCameraLikelihood, LeavesARegionOutOfItsOwnRest) {
  const cv::Rect square(10, 10, 40, 30);
  const cv::Mat image = wallWithSquare(square, {40, 40, 200});
  cv::Mat region = cv::Mat::zeros(image.size(), CV_8UC1);
  region(square).setTo(255);
  const color::OtherCameraLikelihood likelihood({kRed});
  EXPECT_LT(nats(likelihood.likelihoodForImage(image, everywhere(image)), kRed), 0.0);
  EXPECT_GT(likelihood.meanLogLikelihoodRatio(image, everywhere(image), region), 2.0);
  EXPECT_EQ(likelihood.meanLogLikelihoodRatio(image, everywhere(image),
                                              cv::Mat::zeros(image.size(), CV_8UC1)),
            0.0);
}

// A red thing where the target cannot be makes red five times rarer than one where it can.
TEST(OtherCameraLikelihood, CountsLittleWhatCannotBeTheTarget) {
  const cv::Rect square(50, 10, 20, 20);
  const cv::Mat image = wallWithSquare(square, {40, 40, 200});
  cv::Mat near = everywhere(image);
  near(square).setTo(0);
  const color::OtherCameraLikelihood likelihood({kRed});
  EXPECT_GT(nats(likelihood.likelihoodForImage(image, near), kRed),
            nats(likelihood.likelihoodForImage(image, everywhere(image)), kRed) + 1.0);
}

} // namespace
} // namespace dewpoint::tests
