// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"
#include "core/color/color_palette.h"
#include "core/observation/boxes/box_contrast.h"
#include "core/observation/boxes/click_box.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <numeric>
#include <utility>

namespace dewpoint::tests {
namespace {

const cv::Scalar kPinkPaint(140, 70, 220);
const Eigen::Vector2d kBoxCenter(160.0, 120.0);

/// A wall that gets darker to the right with a ball on it, lit from the upper left (Lambert, 0.35
/// of it ambient) with a white highlight, a dark seam across, and noise of 4 gray levels.
cv::Mat ball(double radius) {
  cv::Mat image(240, 320, CV_8UC3);
  const RandomStream stream(3, 0, 0, RandomPurpose::Simulation);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      const double u = (x + 0.5 - kBoxCenter.x()) / radius;
      const double v = (y + 0.5 - kBoxCenter.y()) / radius;
      const double inside = 1.0 - u * u - v * v;
      const double facing =
          inside < 0.0 ? 0.0 : std::max(0.0, -0.5 * u - 0.6 * v + 0.62 * std::sqrt(inside));
      const double seam = std::abs(u - 0.2) < 0.08 ? 0.5 : 1.0;
      const auto words = stream.randomWords(std::uint32_t(320 * y + x));
      for (int c = 0; c < 3; ++c) {
        const double clean = inside < 0.0 ? 150.0 + 8.0 * c - x / 5.0
                                          : seam * kPinkPaint[c] * (0.35 + 0.75 * facing) +
                                                250.0 * std::pow(facing, 60.0);
        const double noise = double(words[std::size_t(c)] % 15) - 7.0; // uniform: deviation 4.3
        image.at<cv::Vec3b>(y, x)[c] = cv::saturate_cast<std::uint8_t>(clean + noise);
      }
    }
  }
  return image;
}

class ClickBoxTest : public ::testing::TestWithParam<double> {};

// Wherever the inner half of the disc is clicked: on the highlight, on the seam, in the shade. Half
// of the area in common is what counts as found (PASCAL VOC).
TEST_P(ClickBoxTest, FindsABallWhereverItIsClicked) {
  const double radius = GetParam();
  const cv::Mat image = ball(radius);
  const ImageBox truth = ImageBox::around(kBoxCenter, 2.0 * radius, 2.0 * radius);
  for (const double r : {0.0, 0.25, 0.5}) {
    for (int direction = 0; direction < 8; ++direction) {
      const double angle = 0.25 * M_PI * direction;
      const Eigen::Vector2d click =
          kBoxCenter + r * radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      const auto box = boxAroundClick(image, click);
      ASSERT_TRUE(box);
      EXPECT_GE(intersectionOverUnion(*box, truth), 0.5)
          << click.transpose() << ": " << box->x << ' ' << box->y << ' ' << box->width << ' '
          << box->height;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Radii, ClickBoxTest, ::testing::Values(6.0, 14.0, 30.0, 60.0));

TEST(ClickBox, OfSomethingLongIsLong) {
  cv::Mat image(240, 320, CV_8UC3, cv::Scalar(150, 150, 150));
  cv::rectangle(image, {150, 90, 20, 60}, kPinkPaint, cv::FILLED);
  EXPECT_GT(
      intersectionOverUnion(*boxAroundClick(image, {158.0, 112.0}), {150.0, 90.0, 20.0, 60.0}),
      0.8);
}

/// A lit ball of radius 14 in a hand, whose color is between the ball's and the wall's.
cv::Mat heldBall() {
  cv::Mat image = ball(14.0);
  const cv::Rect above(140, 100, 40, 26); // what the hand leaves to be seen
  const cv::Mat held = image(above).clone();
  cv::Mat disk = cv::Mat::zeros(image.size(), CV_8UC1);
  cv::circle(disk, {160, 120}, 14, cv::Scalar(255), cv::FILLED);
  cv::ellipse(image, {160, 134}, {24, 16}, 0.0, 0.0, 360.0, cv::Scalar(120, 110, 170), cv::FILLED);
  held.copyTo(image(above), disk(above));
  return image;
}

// Ball and hand stand out more than the ball, but what would be followed of them is the hand when
// the ball is thrown.
TEST(ClickBox, OfABallInAHandIsNotTheHand) {
  const cv::Mat image = heldBall();
  for (const auto& [x, y] :
       {std::pair(160.0, 113.0), {153.0, 117.0}, {166.0, 120.0}, {160.0, 120.0}, {156.0, 122.0}}) {
    const auto box = boxAroundClick(image, {x, y});
    ASSERT_TRUE(box);
    EXPECT_GT(intersectionOverUnion(*box, {146.0, 106.0, 28.0, 20.0}), 0.5)
        << x << ", " << y << ": " << box->x << ' ' << box->y << ' ' << box->width << ' '
        << box->height;
  }
}

TEST(ClickBox, LiesInTheImage) {
  cv::Mat image(240, 320, CV_8UC3, cv::Scalar(150, 150, 150));
  cv::circle(image, {316, 4}, 14, kPinkPaint, cv::FILLED);
  const auto box = boxAroundClick(image, {315.0, 5.0});
  ASSERT_TRUE(box);
  EXPECT_EQ(intersectionArea(*box, {0.0, 0.0, 320.0, 240.0}), box->area());
  EXPECT_GT(intersectionOverUnion(*box, {302.0, 0.0, 18.0, 19.0}),
            0.5); // what of the disc is in the image
}

TEST(ClickBox, IsNoneWhereNothingStandsOut) {
  EXPECT_FALSE(boxAroundClick(cv::Mat(240, 320, CV_8UC3, cv::Scalar(90, 90, 90)), {100.0, 100.0}));
  EXPECT_FALSE(boxAroundClick(cv::Mat(4, 4, CV_8UC3, cv::Scalar(90, 90, 90)), {2.0, 2.0}));
}

TEST(BoxContrast, IsGreatestForTheThingItself) {
  cv::Mat image(80, 80, CV_8UC3, cv::Scalar(150, 150, 150));
  cv::circle(image, {40, 40}, 8, kPinkPaint, cv::FILLED);
  const BoxContrast contrast(image, {40.0, 40.0});
  const double itself = contrast.contrastOf(ImageBox::around({40.5, 40.5}, 17.0, 17.0));
  EXPECT_GT(itself, 0.5); // of 1: three bands are not quite a disc, its rim is in the ring too
  for (const double size : {8.0, 12.0, 24.0, 34.0}) {
    EXPECT_LT(contrast.contrastOf(ImageBox::around({40.5, 40.5}, size, size)), itself) << size;
  }
  EXPECT_LT(contrast.contrastOf(ImageBox::around({45.5, 40.5}, 17.0, 17.0)), itself);
  EXPECT_EQ(BoxContrast(image, {10.0, 10.0}).contrastOf(ImageBox::around({40.5, 40.5}, 17.0, 17.0)),
            0.0)
      << "the pixel has the color of the ring";
}

TEST(ColorPalette, TellsColorsApartAndMindsLittleShading) {
  cv::Mat image(20, 40, CV_8UC3, cv::Scalar(150, 150, 150));
  image.colRange(0, 10).setTo(kPinkPaint);
  image.colRange(10, 20).setTo(0.8 * kPinkPaint);
  const ColorPalette palette(image, {0, 0});
  const auto label = [&](int x) {
    return std::size_t(palette.colorIndices().at<std::uint8_t>(5, x));
  };
  EXPECT_NE(label(5), label(30));
  ColorPalette::Shares pink{};
  pink[label(5)] = 1.0;
  const ColorPalette::Shares soft = palette.spreadOverSimilarColors(pink);
  EXPECT_NEAR(soft[label(5)], 1.0, 1e-9);
  EXPECT_GT(soft[label(15)], 0.3); // a fifth darker: about 10 units of L*a*b*
  EXPECT_LT(soft[label(30)], 0.01);
}

} // namespace
} // namespace dewpoint::tests
