// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/hsi.h"
#include "core/color/match_image.h"
#include "core/observation/sphere/adaptive_color.h"
#include "tests/observation/drawn_spheres.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <cmath>
#include <vector>

namespace dewpoint::tests {
namespace {

const ColorRange kGreen{90.0, 150.0, 0.3, 0.9, 0.2, 0.7};
const cv::Scalar kGreenBall(60.0, 180.0, 40.0); // hue 129, saturation 0.57, intensity 0.37
const SphereImage kBallOutline{{80.0, 60.0}, 14.0};
constexpr double kShare = 0.05;

/// A green disc on a gray wall, all lit by `gain` (BGR), with sensor noise.
cv::Mat scene(const cv::Scalar& gain, std::uint32_t frame, const cv::Scalar& wall = {90, 90, 90},
              const cv::Scalar& ball = kGreenBall) {
  cv::Mat image(120, 160, CV_8UC3, wall.mul(gain));
  cv::circle(image, {80, 60}, 14, ball.mul(gain), cv::FILLED);
  drawn::addNoise(image, 2.0, frame);
  return image;
}
cv::Scalar gray(double gain) {
  return {gain, gain, gain, 0.0};
}

/// Reference looks in full light.
AdaptiveColor begun() {
  AdaptiveColor color(kGreen, 2);
  for (int k = 0; k < AdaptiveColor::kReferenceUpdateCount; ++k) {
    EXPECT_FALSE(color.adapt(0, scene(gray(1.0), std::uint32_t(k)), kBallOutline, {}, kShare));
  }
  EXPECT_TRUE(color.rangesInUse().empty());
  return color;
}

/// Share of the disc that the range in use takes in.
double takenInUse(const AdaptiveColor& color, const cv::Mat& image) {
  cv::Mat disc = cv::Mat::zeros(image.size(), CV_8UC1);
  cv::circle(disc, {80, 60}, 13, cv::Scalar(255), cv::FILLED);
  return double(cv::countNonZero(matchImage(image, color.classifierInUse(0)) & disc)) /
         cv::countNonZero(disc);
}

// The labels of an image keep these addresses, while the things that own the colors move within
// their vector as further ones are found.
TEST(AdaptiveColor, ItsClassifiersStayWhereTheyAreWhenItIsMoved) {
  std::vector<AdaptiveColor> colors;
  colors.reserve(1);
  colors.emplace_back(kGreen, 2);
  const ColorClassifier* learned = &colors.front().learnedClassifier();
  const ColorClassifier* inUse = &colors.front().classifierInUse(1);
  while (colors.capacity() == 1) {
    colors.emplace_back(kGreen, 2);
  }
  EXPECT_EQ(&colors.front().learnedClassifier(), learned);
  EXPECT_EQ(&colors.front().classifierInUse(1), inUse);
}

/// The green disc with a half that is blue.
cv::Mat twoColored(double light, std::uint32_t frame) {
  cv::Mat image = scene(gray(light), frame);
  const cv::Mat other = scene(gray(light), frame, {90, 90, 90}, {190.0, 90.0, 40.0});
  other.colRange(80, 160).copyTo(image.colRange(80, 160));
  return image;
}

TEST(AdaptiveColor, FollowsEachOfSeveralColors) {
  const ColorRange blue{200.0, 240.0, 0.3, 0.9, 0.2, 0.7};
  AdaptiveColor color(ColorRanges(kGreen, {blue}), 1);
  for (std::uint32_t k = 0; k < 10; ++k) {
    EXPECT_FALSE(color.adapt(0, twoColored(1.0, k), kBallOutline, {}, kShare));
  }
  EXPECT_TRUE(color.rangesInUse().empty());
  EXPECT_GT(takenInUse(color, twoColored(1.0, 11)), 0.97);
  double light = 1.0;
  for (std::uint32_t k = 0; k < 200; ++k) {
    light = 1.0 - 0.55 * k / 200.0;
    color.adapt(0, twoColored(light, k), kBallOutline, {}, kShare);
  }
  const ColorRanges ranges = color.rangesInUse(0);
  ASSERT_EQ(ranges.size(), 2U);
  EXPECT_LT(ranges[0].intensityMin, 0.65 * kGreen.intensityMin);
  EXPECT_LT(ranges[1].intensityMin, 0.65 * blue.intensityMin);
  EXPECT_GT(takenInUse(color, twoColored(light, 201)), 0.97);
}

TEST(AdaptiveColor, AColorThatIsNotSeenStaysWhereItWas) {
  const ColorRange blue{200.0, 240.0, 0.3, 0.9, 0.2, 0.7};
  AdaptiveColor color(ColorRanges(kGreen, {blue}), 1);
  for (std::uint32_t k = 0; k < 200; ++k) {
    color.adapt(0, scene(gray(1.0 - 0.5 * k / 200.0), k), kBallOutline, {}, kShare);
  }
  EXPECT_LT(color.rangesInUse(0)[0].intensityMin, 0.7 * kGreen.intensityMin);
  EXPECT_EQ(color.rangesInUse(0)[1], blue);
}

TEST(AdaptiveColor, StaysAsLearnedInSteadyLight) {
  AdaptiveColor color = begun();
  for (std::uint32_t k = 0; k < 300; ++k) {
    color.adapt(0, scene(gray(1.0), k), kBallOutline, {}, kShare);
  }
  // The quantiles of 400 noisy pixels are off by less than a gray level.
  const ColorRange range = color.rangesInUse(0)[0];
  EXPECT_NEAR(range.hueMin, kGreen.hueMin, 0.5);
  EXPECT_NEAR(range.hueMax, kGreen.hueMax, 0.5);
  EXPECT_NEAR(range.saturationMin, kGreen.saturationMin, 0.01);
  EXPECT_NEAR(range.intensityMax, kGreen.intensityMax, 0.01);
  EXPECT_EQ(color.rangesInUse(1)[0], kGreen) << "the other camera saw nothing";
}

TEST(AdaptiveColor, FollowsLightThatFadesByTheSameFactor) {
  AdaptiveColor color = begun();
  double gain = 1.0;
  for (std::uint32_t k = 0; k < 400; ++k) {
    gain = std::pow(0.25, (k + 1) / 400.0);
    color.adapt(0, scene(gray(gain), k), kBallOutline, {}, kShare);
  }
  const cv::Mat dark = scene(gray(gain), 1000);
  const ColorRange range = color.rangesInUse(0)[0];
  // It lags by 1 / kShare = 20 looks: a factor of 4^(20 / 400) = 1.07. Noise of 2 levels per
  // channel is 1.15 in an intensity of 23 levels: its quantiles are 1.28 x 5 % off, against 1.6 %
  // before.
  EXPECT_NEAR(range.intensityMin / (kGreen.intensityMin * gain), 1.07 * 0.95, 0.03);
  EXPECT_NEAR(range.intensityMax / (kGreen.intensityMax * gain), 1.07 * 1.05, 0.03);
  EXPECT_GT(takenInUse(color, dark), 0.98);
  EXPECT_LT(takenInUse(AdaptiveColor(kGreen, 1), dark), 0.02); // 0.37 / 4 is below 0.2
}

TEST(AdaptiveColor, FollowsATintInItsHue) {
  AdaptiveColor color = begun();
  cv::Scalar gain;
  for (std::uint32_t k = 0; k < 400; ++k) {
    const double way = (k + 1) / 400.0;
    gain = {1.0 - 0.3 * way, 1.0, 1.0 + 0.6 * way, 0.0};
    color.adapt(0, scene(gain, k), kBallOutline, {}, kShare);
  }
  const Hsi before = hsiFromBgr(60, 180, 40);
  const Hsi after = hsiFromBgr(42, 180, 64);
  const double lagging = (after.hueDegrees - before.hueDegrees) * 0.95; // 20 of 400 looks behind
  EXPECT_NEAR(color.rangesInUse(0)[0].hueMin - kGreen.hueMin, lagging, 1.5);
  EXPECT_NEAR(color.rangesInUse(0)[0].hueMax - kGreen.hueMax, lagging, 1.5);
}

TEST(AdaptiveColor, IsNotTakenAlongByWhatHidesTheTarget) {
  AdaptiveColor color = begun();
  const cv::Scalar skin(90.0, 120.0, 190.0);
  for (std::uint32_t k = 0; k < 200; ++k) {
    color.adapt(0, scene(gray(1.0), k, {90, 90, 90}, skin), kBallOutline, {}, kShare);
    color.adapt(1, cv::Mat(), kBallOutline, {}, kShare);
  }
  EXPECT_TRUE(color.rangesInUse().empty());
}

TEST(AdaptiveColor, TakesNoStepOntoTheBackground) {
  // The wall is a darker green, outside the range; the ball darkens towards it, the wall does not.
  const cv::Scalar wall(24.0, 72.0, 16.0); // intensity 0.15
  AdaptiveColor color(kGreen, 1);
  for (std::uint32_t k = 0; k < 500; ++k) {
    const double gain = k < 20 ? 1.0 : std::max(0.4, 1.0 - 0.002 * (k - 20));
    cv::Mat image = scene(gray(1.0), k, wall, kGreenBall.mul(gray(gain)));
    color.adapt(0, image, kBallOutline, {}, kShare);
    const double matched = cv::countNonZero(matchImage(image, color.classifierInUse(0)));
    const double disc = M_PI * 15.0 * 15.0;
    ASSERT_LT(matched, disc + 0.01 * double(image.total())) << k;
  }
  EXPECT_GT(color.rangesInUse(0)[0].intensityMin, 0.15);
  EXPECT_LT(color.rangesInUse(0)[0].intensityMin, 0.2) << "it followed as far as it may";
}

TEST(AdaptiveColor, ForgetsAndCopies) {
  AdaptiveColor color = begun();
  AdaptiveColor copy = color;
  for (std::uint32_t k = 0; k < 50; ++k) {
    EXPECT_TRUE(color.adapt(0, scene(gray(0.8), k), kBallOutline, {}, kShare));
    copy.adapt(0, scene(gray(0.8), k), kBallOutline, {}, kShare);
  }
  EXPECT_EQ(copy.rangesInUse(0)[0], color.rangesInUse(0)[0]);
  EXPECT_FALSE(color.rangesInUse(0)[0] == kGreen);
  color.restoreLearnedRanges();
  EXPECT_TRUE(color.rangesInUse().empty());
  EXPECT_FALSE(copy.rangesInUse().empty());
}

} // namespace
} // namespace dewpoint::tests
