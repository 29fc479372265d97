// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/borrowed_image.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace dewpoint::tests {
namespace {

TEST(BorrowedImage, ShowsThePixelsWhereTheyAre) {
  std::vector<std::uint8_t> pixels(2 * 8, 7); // two rows of two pixels, and two bytes between them
  pixels[8 + 3] = 9;                          // second row, second pixel, blue
  const cv::Mat image = borrowedImage(2, 2, pixels.data(), 8, nullptr);
  EXPECT_EQ(image.data, pixels.data());
  EXPECT_EQ(image.size(), cv::Size(2, 2));
  EXPECT_EQ(image.at<cv::Vec3b>(1, 1), cv::Vec3b(9, 7, 7));
}

TEST(BorrowedImage, ReleasesTheOwnerWithTheLastImage) {
  auto pixels = std::make_shared<std::vector<std::uint8_t>>(3 * 4 * 4, std::uint8_t{1});
  const std::weak_ptr<std::vector<std::uint8_t>> watched = pixels;
  cv::Mat part;
  {
    std::uint8_t* const first = pixels->data();
    const cv::Mat image = borrowedImage(4, 4, first, 12, std::move(pixels));
    const cv::Mat same = image;
    part = same(cv::Rect(1, 1, 2, 2));
  }
  EXPECT_FALSE(watched.expired());
  const cv::Mat copy = part.clone();
  part.release();
  EXPECT_TRUE(watched.expired());
  EXPECT_EQ(copy.at<cv::Vec3b>(0, 0), cv::Vec3b(1, 1, 1));
}

TEST(BorrowedImage, IsReplacedByMemoryOfItsOwn) {
  std::vector<std::uint8_t> pixels(3 * 4 * 4, 1);
  cv::Mat image = borrowedImage(4, 4, pixels.data(), 12, nullptr);
  image.create(8, 8, CV_8UC3);
  image.setTo(cv::Scalar::all(2));
  EXPECT_EQ(pixels, std::vector<std::uint8_t>(3 * 4 * 4, 1));
}

} // namespace
} // namespace dewpoint::tests
