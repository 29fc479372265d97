// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/image_shape.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace dewpoint::tests {
namespace {

cv::Mat randomImage() {
  cv::Mat image(40, 60, CV_8UC3);
  cv::randu(image, cv::Scalar::all(0), cv::Scalar::all(255));
  return image;
}

TEST(ImageShape, CropsAfterRotationAndMirroring) {
  const cv::Mat sent = randomImage();
  cv::Mat whole;
  cv::rotate(sent, whole, cv::ROTATE_90_CLOCKWISE);
  cv::flip(whole, whole, 1);
  ImageShape shape{"left", 90, 0, 0, true, {3, 2, 5, 7}};
  const auto image = prepareImage(sent, shape, "left.mkv");
  ASSERT_TRUE(image) << errorSentence(image.error());
  EXPECT_EQ(image->size(), cv::Size(40 - 8, 60 - 9));
  EXPECT_TRUE(image->isContinuous());
  EXPECT_EQ(cv::norm(*image, whole(cv::Rect(3, 2, 32, 51)), cv::NORM_INF), 0.0);
  // The expected size is that of the cropped image.
  shape.width = 32;
  shape.height = 51;
  EXPECT_TRUE(prepareImage(sent, shape, ""));
  shape.width = 40;
  EXPECT_EQ(prepareImage(sent, shape, "").error().code, ErrorCode::Mismatch);
}

TEST(ImageShape, MarginsThatLeaveNothingAreAnError) {
  const ImageShape shape{"left", 0, 0, 0, false, {30, 0, 30, 0}};
  EXPECT_TRUE(checkShape(shape, "left.mkv"));
  const auto image = prepareImage(randomImage(), shape, "left.mkv");
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().code, ErrorCode::Mismatch);
  EXPECT_EQ(image.error().file, "left.mkv");
  EXPECT_EQ(image.error().field, "camera 'left'");
  EXPECT_EQ(checkShape({"left", 0, 0, 0, false, {0, 0, -1, 0}}, "").error().code,
            ErrorCode::BadValue);
}

} // namespace
} // namespace dewpoint::tests
