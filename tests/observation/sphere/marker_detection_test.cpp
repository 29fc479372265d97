// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/sphere/marker_detection.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <cmath>

namespace dewpoint::tests {
namespace {

const ColorRange kMarkerRed{340.0, 20.0, 0.4, 1.0, 0.1, 0.9};

/// A gray image with a red disk, anti-aliased by 8 x 8 samples per pixel.
cv::Mat disk(double column, double row, double radius) {
  cv::Mat image(120, 160, CV_8UC3);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      int inside = 0;
      for (int k = 0; k < 64; ++k) {
        const double dx = x + (k % 8 - 3.5) / 8.0 - column;
        const double dy = y + (int(k / 8) - 3.5) / 8.0 - row;
        inside += dx * dx + dy * dy < radius * radius ? 1 : 0;
      }
      const double share = inside / 64.0;
      const auto mixed = [&](double ball, double wall) {
        return cv::saturate_cast<std::uint8_t>(share * ball + (1.0 - share) * wall);
      };
      image.at<cv::Vec3b>(y, x) = {mixed(30, 120), mixed(30, 120), mixed(220, 120)};
    }
  }
  return image;
}

TEST(MarkerDetector, FindsTheMiddleToFewHundredthsOfAPixel) {
  MarkerDetector finder{ColorClassifier(kMarkerRed)};
  double sum = 0.0;
  for (int k = 0; k < 40; ++k) {
    const double x = 70.0 + 0.37 * k;
    const double y = 50.0 + 0.23 * k;
    const auto ball = finder.find(disk(x, y, 7.3));
    ASSERT_TRUE(ball);
    const double off = (ball->outline.center - Eigen::Vector2d(x, y)).norm();
    EXPECT_LT(off, 0.08);
    EXPECT_NEAR(ball->outline.radius, 7.3, 0.1);
    sum += off * off;
  }
  EXPECT_LT(std::sqrt(sum / 40.0), 0.04);
}

TEST(MarkerDetector, LeavesOutWhatIsNotAWholeBall) {
  MarkerDetector finder{ColorClassifier(kMarkerRed)};
  EXPECT_FALSE(finder.find(disk(3.0, 50.0, 7.0)));  // cut by the border
  EXPECT_FALSE(finder.find(disk(80.0, 50.0, 1.0))); // too small
  EXPECT_FALSE(finder.find(cv::Mat(120, 160, CV_8UC3, cv::Scalar(120, 120, 120))));
  cv::Mat half = disk(80.0, 50.0, 10.0);
  cv::rectangle(half, {80, 30, 30, 40}, cv::Scalar(120, 120, 120), cv::FILLED); // half hidden
  EXPECT_FALSE(finder.find(half));
  cv::Mat two = disk(50.0, 50.0, 8.0);
  cv::circle(two, {110, 60}, 8, cv::Scalar(30, 30, 220), cv::FILLED); // which one?
  EXPECT_FALSE(finder.find(two));
}

} // namespace
} // namespace dewpoint::tests
