// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/manual/click_aids.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace dewpoint::tests {
namespace {

/// A dark square whose upper left corner lies at exactly (x, y), drawn 16 times finer and averaged.
cv::Mat corner(double x, double y) {
  constexpr int kFine = 16;
  cv::Mat fine(60 * kFine, 80 * kFine, CV_8UC3, cv::Scalar::all(220));
  // Pixel p covers p - 0.5 to p + 0.5.
  cv::rectangle(fine,
                cv::Rect(int((x + 0.5) * kFine), int((y + 0.5) * kFine), 25 * kFine, 20 * kFine),
                cv::Scalar::all(30), cv::FILLED);
  cv::Mat image;
  cv::resize(fine, image, {80, 60}, 0, 0, cv::INTER_AREA);
  return image;
}

TEST(ClickAids, AClickNearACornerSnapsToIt) {
  for (const double offset : {0.0, 0.25, 0.5, 0.75}) {
    const Eigen::Vector2d truth(30.0 + offset, 25.0 + offset);
    const auto found = snapToCorner(corner(truth.x(), truth.y()), {33.0, 22.0}, 8.0);
    ASSERT_TRUE(found);
    EXPECT_LT((*found - truth).norm(), 0.35) << found->transpose();
  }
}

TEST(ClickAids, ACrossingOfFieldsIsFoundExactly) {
  // Where four fields of a chessboard meet cornerSubPix has no bias.
  cv::Mat fine(960, 1280, CV_8UC1, cv::Scalar(220));
  fine(cv::Rect(0, 0, 488, 408)).setTo(30);
  fine(cv::Rect(488, 408, 792, 552)).setTo(30);
  cv::Mat image;
  cv::resize(fine, image, {80, 60}, 0, 0, cv::INTER_AREA);
  const auto found = snapToCorner(image, {33.0, 23.0}, 8.0);
  ASSERT_TRUE(found);
  // 488 / 16 - 0.5 and 408 / 16 - 0.5.
  EXPECT_LT((*found - Eigen::Vector2d(30.0, 25.0)).norm(), 0.05);
}

TEST(ClickAids, NoiseHasNoCorners) {
  cv::Mat image(60, 80, CV_8UC3);
  cv::RNG numbers(7);
  numbers.fill(image, cv::RNG::NORMAL, 150.0, 6.0); // as dim webcams have it
  EXPECT_FALSE(snapToCorner(image, {40.0, 30.0}, 8.0));
}

TEST(ClickAids, NothingThereIsNothing) {
  EXPECT_FALSE(snapToCorner(corner(30, 25), {70.0, 8.0}, 6.0)) << "a flat place";
  EXPECT_FALSE(snapToCorner(corner(30, 25), {-500.0, 8.0}, 6.0));
  EXPECT_FALSE(snapToCorner(cv::Mat(), {3.0, 8.0}, 6.0));
}

TEST(ClickAids, TheMagnifierShowsThePixelInTheMiddle) {
  cv::Mat image(20, 20, CV_8UC3, cv::Scalar::all(0));
  image.at<cv::Vec3b>(7, 12) = {10, 20, 250};
  const cv::Mat large = magnified(image, {12.0, 7.0}, 80, 8);
  ASSERT_EQ(large.size(), cv::Size(80, 80));
  // The pixel covers 8 x 8, centered.
  EXPECT_EQ(large.at<cv::Vec3b>(40, 40), cv::Vec3b(10, 20, 250));
  EXPECT_EQ(large.at<cv::Vec3b>(37, 37), cv::Vec3b(10, 20, 250));
  EXPECT_EQ(large.at<cv::Vec3b>(43, 43), cv::Vec3b(10, 20, 250));
  EXPECT_EQ(large.at<cv::Vec3b>(34, 40), cv::Vec3b(0, 0, 0));
  EXPECT_EQ(large.at<cv::Vec3b>(40, 45), cv::Vec3b(0, 0, 0));
}

TEST(ClickAids, EdgesAreBrightAndPlanesDark) {
  const cv::Mat edges = edgeStrengthImage(corner(30, 25));
  ASSERT_EQ(edges.type(), CV_8UC1);
  EXPECT_GT(edges.at<uchar>(35, 30), 100);
  EXPECT_EQ(edges.at<uchar>(35, 40), 0);
  EXPECT_EQ(edges.at<uchar>(10, 10), 0);
}

TEST(ClickAids, EdgesAreFoundInTheSizeThatIsShown) {
  const cv::Mat image = corner(30, 25);
  const cv::Mat same = edgeStrengthImage(image, image.size());
  EXPECT_EQ(cv::norm(same, edgeStrengthImage(image), cv::NORM_INF), 0.0);
  const cv::Mat half = edgeStrengthImage(image, {image.cols / 2, image.rows / 2});
  ASSERT_EQ(half.size(), cv::Size(image.cols / 2, image.rows / 2));
  EXPECT_GT(half.at<uchar>(17, 15), 100);
  EXPECT_EQ(half.at<uchar>(17, 20), 0);
  EXPECT_EQ(cv::countNonZero(edgeStrengthImage(cv::Mat(), {4, 3})), 0); // no image, no edges
}

} // namespace
} // namespace dewpoint::tests
