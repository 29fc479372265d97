// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/models.h"
#include "core/observation/sphere/color_window.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <cmath>
#include <limits>

namespace dewpoint::tests {
namespace {

static_assert(ObservationModel<ColorWindow>);

constexpr int kWindowWidth = 40;
constexpr int kWindowHeight = 30;
const ColorRange kPureRed{340.0, 20.0, 0.5, 1.0, 0.1, 0.9}; // pure red is hue 0, S 1, I 1/3

/// At the world origin, looking along +z: the point (x, y, 1) is pixel (100 x + 20, 100 y + 15).
Camera simpleCamera() {
  Camera camera;
  camera.intrinsics = {kWindowWidth, kWindowHeight, 100.0, 100.0, 20.0, 15.0};
  return camera;
}

Eigen::Vector3d atPixel(double column, double row) {
  return {(column - 20.0) / 100.0, (row - 15.0) / 100.0, 1.0};
}

cv::Mat blankImage() {
  return {kWindowHeight, kWindowWidth, CV_8UC3, cv::Scalar(255, 255, 255)};
}
cv::Mat redImage() {
  return {kWindowHeight, kWindowWidth, CV_8UC3, cv::Scalar(0, 0, 255)};
}
void paintPixel(cv::Mat& image, int column, int row) {
  image.at<cv::Vec3b>(row, column) = cv::Vec3b(0, 0, 255);
}

double likelihood(const ColorWindow& window, const Eigen::Vector3d& point) {
  Eigen::ArrayXXd states(1, 3);
  states.row(0) = point.transpose();
  Eigen::ArrayXd logs = Eigen::ArrayXd::Zero(1);
  window.addLogLikelihood(states, logs);
  return std::exp(logs[0]);
}

ColorWindow oneCamera(const cv::Mat& image) {
  ColorWindow window({simpleCamera()}, ColorClassifier(kPureRed));
  window.setImage(0, image);
  return window;
}

// Equation 7: m / 25.
TEST(ColorWindow, CountsTheMatchesInFiveByFive) {
  cv::Mat image = blankImage();
  for (int column = 9; column < 12; ++column) {
    paintPixel(image, column, 10);
  }
  paintPixel(image, 13, 10); // 3 away from column 10: outside its window
  paintPixel(image, 10, 7);  // 3 above
  const ColorWindow window = oneCamera(image);
  EXPECT_EQ(window.matchCount(0, atPixel(10, 10)), 3);
  EXPECT_NEAR(likelihood(window, atPixel(10, 10)), 3.0 / 25.0, 1e-15);
  EXPECT_EQ(window.matchCount(0, atPixel(11, 10)), 4); // columns 9 to 13
  EXPECT_EQ(window.matchCount(0, atPixel(10, 9)), 4);  // rows 7 to 11
  EXPECT_NEAR(likelihood(oneCamera(redImage()), atPixel(10, 10)), 1.0, 1e-15);
}

TEST(ColorWindow, NoMatchIsRaisedToOne) {
  const ColorWindow window = oneCamera(blankImage());
  EXPECT_EQ(window.matchCount(0, atPixel(10, 10)), 0);
  EXPECT_NEAR(likelihood(window, atPixel(10, 10)), 1.0 / 25.0, 1e-15);
}

// Equation 6, even though every pixel of the image matches.
TEST(ColorWindow, OutsideOrBehindIsOneTwentyFifth) {
  const ColorWindow window = oneCamera(redImage());
  const double notANumber = std::numeric_limits<double>::quiet_NaN();
  for (const Eigen::Vector3d& point :
       {atPixel(-1, 10), atPixel(kWindowWidth, 10), atPixel(10, -1), atPixel(10, kWindowHeight),
        Eigen::Vector3d(0, 0, -1), Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1e300, 0, 1e-300),
        Eigen::Vector3d(notANumber, 0, 1)}) {
    EXPECT_FALSE(window.matchCount(0, point));
    EXPECT_NEAR(likelihood(window, point), 1.0 / 25.0, 1e-15) << point.transpose();
  }
}

// All pixels match; a window cut by the border has fewer, the divisor stays 25.
TEST(ColorWindow, BorderCutsTheWindowButNotTheDivisor) {
  const ColorWindow window = oneCamera(redImage());
  EXPECT_NEAR(likelihood(window, atPixel(0, 0)), 9.0 / 25.0, 1e-15);
  EXPECT_NEAR(likelihood(window, atPixel(1, 0)), 12.0 / 25.0, 1e-15);
  EXPECT_NEAR(likelihood(window, atPixel(0, 10)), 15.0 / 25.0, 1e-15);
  EXPECT_NEAR(likelihood(window, atPixel(1, 10)), 20.0 / 25.0, 1e-15);
  EXPECT_NEAR(likelihood(window, atPixel(2, 2)), 1.0, 1e-15);
  EXPECT_NEAR(likelihood(window, atPixel(kWindowWidth - 1, kWindowHeight - 1)), 9.0 / 25.0, 1e-15);
  EXPECT_NEAR(likelihood(window, atPixel(kWindowWidth - 2, kWindowHeight - 1)), 12.0 / 25.0, 1e-15);
}

// Pixel centers lie at integers, so pixel 0 begins at -0.5 and pixel 39 ends at 39.5.
TEST(ColorWindow, ProjectionIsRoundedToTheNearestPixel) {
  cv::Mat image = blankImage();
  paintPixel(image, 10, 10);
  const ColorWindow window = oneCamera(image);
  EXPECT_EQ(window.matchCount(0, atPixel(12.4, 10)), 1);
  EXPECT_EQ(window.matchCount(0, atPixel(12.6, 10)), 0);
  EXPECT_EQ(window.matchCount(0, atPixel(7.6, 10)), 1);
  EXPECT_EQ(window.matchCount(0, atPixel(7.4, 10)), 0);
  EXPECT_TRUE(window.matchCount(0, atPixel(-0.4, 10)));
  EXPECT_FALSE(window.matchCount(0, atPixel(-0.6, 10)));
  EXPECT_TRUE(window.matchCount(0, atPixel(39.4, 10)));
  EXPECT_FALSE(window.matchCount(0, atPixel(39.6, 10)));
}

// Equation 5, for three cameras: 3/25 * 1/25 (outside) * 25/25; a camera without image leaves it.
TEST(ColorWindow, CamerasMultiply) {
  Camera shifted = simpleCamera();
  shifted.intrinsics.centerX = -100.0;
  ColorWindow window({simpleCamera(), shifted, simpleCamera()}, ColorClassifier(kPureRed));
  cv::Mat image = blankImage();
  paintPixel(image, 9, 10);
  paintPixel(image, 10, 11);
  paintPixel(image, 12, 12);
  window.setImage(0, image);
  EXPECT_NEAR(likelihood(window, atPixel(10, 10)), 3.0 / 25.0, 1e-15);
  window.setImage(1, redImage());
  EXPECT_NEAR(likelihood(window, atPixel(10, 10)), 3.0 / 625.0, 1e-15);
  window.setImage(2, redImage());
  EXPECT_NEAR(likelihood(window, atPixel(10, 10)), 3.0 / 625.0, 1e-15);
  window.setImage(0, {});
  EXPECT_NEAR(likelihood(window, atPixel(10, 10)), 1.0 / 25.0, 1e-15);
  EXPECT_FALSE(window.matchCount(0, atPixel(10, 10)));
  window.setImage(1, {});
  window.setImage(2, {});
  EXPECT_EQ(likelihood(window, atPixel(10, 10)), 1.0);
}

TEST(ColorWindow, AddsToWhatIsThere) {
  const ColorWindow window = oneCamera(blankImage());
  Eigen::ArrayXXd states(1, 3);
  states.row(0) = atPixel(10, 10).transpose();
  Eigen::ArrayXd logs = Eigen::ArrayXd::Constant(1, 2.0);
  window.addLogLikelihood(states, logs);
  EXPECT_NEAR(logs[0], 2.0 - std::log(25.0), 1e-15);
}

// An image of 40x30 = 1200 pixels: from 20 particles (1200 / 60) on it is counted as a whole.
TEST(ColorWindow, LazyAndIntegralAgreeToTheBit) {
  const RandomStream stream(5, 0, 0, RandomPurpose::Noise);
  cv::Mat image = blankImage();
  for (int pixel = 0; pixel < kWindowWidth * kWindowHeight; ++pixel) {
    const auto word = stream.randomWords(static_cast<std::uint32_t>(pixel));
    image.at<cv::Vec3b>(pixel / kWindowWidth, pixel % kWindowWidth) = cv::Vec3b(
        static_cast<std::uint8_t>(word[0] % 128), static_cast<std::uint8_t>(word[1] % 128),
        static_cast<std::uint8_t>(word[2] % 256));
  }
  ColorWindow window = oneCamera(image);
  Eigen::ArrayXXd states(4000, 3);
  for (Eigen::Index i = 0; i < states.rows(); ++i) {
    const auto unit = stream.uniform3(static_cast<std::uint32_t>(i), 1);
    states.row(i) = atPixel(unit[0] * 46 - 3, unit[1] * 36 - 3).transpose().array();
  }
  const auto evaluate = [&] {
    Eigen::ArrayXd logs = Eigen::ArrayXd::Zero(states.rows());
    window.addLogLikelihood(states, logs);
    return logs;
  };
  const Eigen::ArrayXd lazy = evaluate();
  EXPECT_GT(lazy.maxCoeff(), lazy.minCoeff()); // there is something to compare
  for (const std::int64_t particleCount : {19, 20, 4000, 19, 48}) {
    window.prepare(particleCount);
    EXPECT_TRUE((evaluate() == lazy).all()) << particleCount;
  }
  window.prepare(4000); // counts of an old color or image must not survive
  window.setClassifier(ColorClassifier(ColorRange{100.0, 101.0, 0.99, 1.0, 0.9, 1.0}));
  window.prepare(4000);
  EXPECT_TRUE((evaluate() == std::log(1.0 / 25.0)).all());
  window.setClassifier(ColorClassifier(kPureRed));
  window.setImage(0, redImage());
  window.prepare(4000);
  EXPECT_EQ(evaluate().maxCoeff(), 0.0);
}

} // namespace
} // namespace dewpoint::tests
