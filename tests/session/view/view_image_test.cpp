// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/view/view_image.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace dewpoint::tests {
namespace {

// Two targets' pixels beside two that belong to nobody, which stay as they are. Of (200, 100, 40) a
// mask leaves 75 %: (150, 75, 30); a tint of (20, 220, 120) adds a quarter of itself: (5, 55, 30).
TEST(ViewImage, AMaskTintsLightly) {
  const cv::Mat image(1, 4, CV_8UC3, cv::Scalar(200, 100, 40));
  cv::Mat mask(1, 4, CV_8UC1, cv::Scalar(0));
  mask.at<uchar>(1) = 255;
  mask.at<uchar>(3) = 254;
  cv::Mat tints(1, 256, CV_8UC3, cv::Scalar::all(0));
  tints.at<cv::Vec3b>(255) = {20, 220, 120};
  tints.at<cv::Vec3b>(254) = {0, 0, 0};
  const cv::Mat shown = tintedImage(image, mask, tints);
  EXPECT_EQ(shown.at<cv::Vec3b>(0), cv::Vec3b(200, 100, 40));
  EXPECT_EQ(shown.at<cv::Vec3b>(1), cv::Vec3b(155, 130, 60));
  EXPECT_EQ(shown.at<cv::Vec3b>(2), cv::Vec3b(200, 100, 40));
  EXPECT_EQ(shown.at<cv::Vec3b>(3), cv::Vec3b(150, 75, 30));  // black adds nothing
  EXPECT_EQ(image.at<cv::Vec3b>(1), cv::Vec3b(200, 100, 40)); // it may be shared
}

TEST(ViewImage, AMaskHasAContour) {
  cv::Mat mask(6, 6, CV_8UC1, cv::Scalar(0));
  mask(cv::Rect(1, 1, 4, 4)).setTo(255);
  cv::Mat tints(1, 256, CV_8UC3, cv::Scalar(20, 220, 120));
  cv::Mat view(12, 12, CV_8UC3, cv::Scalar::all(100)); // twice as large
  drawMaskOutline(view, mask, tints);
  EXPECT_EQ(view.at<cv::Vec3b>(6, 6), cv::Vec3b(100, 100, 100)); // inside
  EXPECT_EQ(view.at<cv::Vec3b>(6, 2), cv::Vec3b(20, 220, 120));  // its border
  EXPECT_EQ(view.at<cv::Vec3b>(6, 1), cv::Vec3b(40, 40, 40));    // and around it
  EXPECT_EQ(view.at<cv::Vec3b>(6, 0), cv::Vec3b(100, 100, 100)); // outside
}

TEST(ViewImage, AMaskAtTheBorderOfTheImageHasAContourInsideOnly) {
  const cv::Size size(12, 10);
  cv::Mat tints(1, 256, CV_8UC3, cv::Scalar(20, 220, 120));
  for (const cv::Rect& masked : {cv::Rect(0, 0, 3, 4), cv::Rect(9, 6, 3, 4), cv::Rect(5, 0, 1, 10),
                                 cv::Rect({}, size), cv::Rect()}) {
    cv::Mat mask(size, CV_8UC1, cv::Scalar(0));
    mask(masked).setTo(255);
    cv::Mat view(size, CV_8UC3, cv::Scalar::all(100));
    drawMaskOutline(view, mask, tints);
    // What is outside the image is no neighbor: only along the image are there border pixels.
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const cv::Rect near = cv::Rect(x - 1, y - 1, 3, 3) & cv::Rect({}, size);
        const int count = cv::countNonZero(mask(near));
        const bool isMasked = mask.at<uchar>(y, x) != 0;
        const cv::Vec3b expected = isMasked && count < near.area() ? cv::Vec3b(20, 220, 120)
                                   : !isMasked && count > 0        ? cv::Vec3b(40, 40, 40)
                                                                   : cv::Vec3b(100, 100, 100);
        EXPECT_EQ(view.at<cv::Vec3b>(y, x), expected) << masked << " at " << x << ", " << y;
      }
    }
    const cv::Mat image(size, CV_8UC3, cv::Scalar::all(100));
    const cv::Mat tinted = tintedImage(image, mask, tints);
    EXPECT_EQ(cv::countNonZero(tinted.reshape(1) != 100), 3 * masked.area()) << masked;
  }
}

TEST(ViewImage, PixelsAreSquaresInAnEnlargedImage) {
  cv::Mat image(1, 2, CV_8UC3, cv::Scalar::all(10));
  image.at<cv::Vec3b>(0, 1) = {90, 80, 70};
  const cv::Mat large = enlargedImage(image, {10, 5});
  EXPECT_EQ(large.at<cv::Vec3b>(0, 4), cv::Vec3b(10, 10, 10));
  EXPECT_EQ(large.at<cv::Vec3b>(4, 5), cv::Vec3b(90, 80, 70));
}

TEST(ViewImage, FitsAnImageIntoAView) {
  cv::Mat image(2, 4, CV_8UC3, cv::Scalar::all(10));
  image.colRange(0, 2).setTo(cv::Scalar::all(30));
  image.at<cv::Vec3b>(0, 0) = {70, 70, 70};
  const cv::Mat half = fittedImage(image, {2, 1}); // means of 2 x 2 pixels
  ASSERT_EQ(half.size(), cv::Size(2, 1));
  EXPECT_EQ(half.at<cv::Vec3b>(0, 0), cv::Vec3b(40, 40, 40));
  EXPECT_EQ(half.at<cv::Vec3b>(0, 1), cv::Vec3b(10, 10, 10));
  const cv::Mat large = fittedImage(image, {40, 20});
  ASSERT_EQ(large.size(), cv::Size(40, 20));
  EXPECT_EQ(large.at<cv::Vec3b>(19, 39), cv::Vec3b(10, 10, 10));
  EXPECT_EQ(cv::norm(fittedImage(image, image.size()), image, cv::NORM_INF), 0.0);
}

// The stops of the scale: at its ends, in the middle, and beyond both ends.
TEST(ViewImage, LikelihoodRisesFromDarkToBright) {
  LikelihoodMap map;
  map.area = cv::Rect(7, 9, 5, 1);
  map.minLogLikelihood = -8.0;
  map.maxLogLikelihood = 4.0;
  map.logLikelihood = (cv::Mat_<float>(1, 5) << -100.0F, -8.0F, -2.0F, 4.0F, 100.0F);
  const cv::Mat shown = likelihoodImage(map);
  ASSERT_EQ(shown.size(), cv::Size(5, 1));
  const cv::Vec4b dark(80, 8, 13, 255);
  const cv::Vec4b bright(130, 240, 250, 255);
  EXPECT_EQ(shown.at<cv::Vec4b>(0), dark);
  EXPECT_EQ(shown.at<cv::Vec4b>(1), dark);
  EXPECT_EQ(shown.at<cv::Vec4b>(2), cv::Vec4b(110, 60, 200, 255));
  EXPECT_EQ(shown.at<cv::Vec4b>(3), bright);
  EXPECT_EQ(shown.at<cv::Vec4b>(4), bright);
  map.minLogLikelihood = map.maxLogLikelihood; // nothing to tell apart: no division by zero
  map.logLikelihood = cv::Mat(1, 5, CV_32F, cv::Scalar(4.0));
  EXPECT_EQ(likelihoodImage(map).at<cv::Vec4b>(0), dark);
}

} // namespace
} // namespace dewpoint::tests
