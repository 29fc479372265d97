// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/color_histogram.h"
#include "core/color/color_learning.h"
#include "core/color/color_region.h"
#include "core/color/match_image.h"
#include "tests/color/red_samples.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <cmath>
#include <numbers>
#include <numeric>

namespace dewpoint::tests {
namespace {

constexpr double kRadius = 15.0;
const cv::Scalar kPink(140, 70, 220);
const cv::Scalar kSkin(120, 150, 200);

/// A ball lit from the upper left (Lambert, 0.35 of it ambient) with a white highlight.
void drawBall(cv::Mat& image, cv::Point center, const cv::Scalar& color, double radius = kRadius) {
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      const double u = (x - center.x) / radius;
      const double v = (y - center.y) / radius;
      const double r2 = u * u + v * v;
      if (r2 > 1.0) {
        continue;
      }
      const double facing = std::max(0.0, (-0.5 * u - 0.6 * v + 0.62 * std::sqrt(1.0 - r2)));
      const double gloss = 250.0 * std::pow(facing, 60.0);
      for (int c = 0; c < 3; ++c) {
        image.at<cv::Vec3b>(y, x)[c] =
            cv::saturate_cast<std::uint8_t>(color[c] * (0.35 + 0.75 * facing) + gloss);
      }
    }
  }
}

/// A gray wall that gets darker to the right, and noise.
cv::Mat room(const std::vector<std::pair<cv::Point, cv::Scalar>>& balls, int seed = 1) {
  cv::Mat image(240, 320, CV_8UC3);
  for (int x = 0; x < image.cols; ++x) {
    image.col(x).setTo(cv::Scalar(150 - x / 5, 160 - x / 5, 165 - x / 5));
  }
  for (const auto& [center, color] : balls) {
    drawBall(image, center, color);
  }
  cv::GaussianBlur(image, image, {3, 3}, 0.8);
  cv::Mat noise(image.size(), CV_16SC3);
  cv::RNG random(static_cast<std::uint64_t>(seed));
  random.fill(noise, cv::RNG::NORMAL, 0.0, 4.0);
  cv::add(image, noise, image, cv::noArray(), CV_8U);
  return image;
}

cv::Mat disc(cv::Point center) {
  cv::Mat mask = cv::Mat::zeros(240, 320, CV_8UC1);
  cv::circle(mask, center, int(kRadius), cv::Scalar(255), cv::FILLED);
  return mask;
}

double f1(const cv::Mat& found, const cv::Mat& truth) {
  const double both = cv::countNonZero(found & truth);
  return 2.0 * both / (cv::countNonZero(found) + cv::countNonZero(truth));
}

ColorSample clickAt(const cv::Mat& image, cv::Point at, bool excluded = false) {
  ColorSample place;
  place.x = at.x;
  place.y = at.y;
  place.isExcluded = excluded;
  return *takeSample(image, place);
}

// Four colors of the target, each on 1 % of its area; three of them are a quarter of the image
// each. A range for one is the best there is: it holds a quarter of the target, F1 = 2 * 0.25
// / 1.25, and nothing of the room. The range for all would hold three quarters of the room.
TEST(ColorAssessment, SaysThatTheTargetIsMissedRatherThanTheRoomHit) {
  const std::vector<cv::Scalar> floor{{40, 40, 160}, {40, 80, 160}, {40, 120, 160}};
  cv::Mat image(240, 320, CV_8UC3, cv::Scalar(200, 60, 20));
  for (int i = 0; i < 3; ++i) {
    image(cv::Rect(80 * i, 0, 80, 240)).setTo(floor[std::size_t(i)]);
  }
  const auto samples =
      std::vector{sampleOf({{40, 40, 160}, {40, 80, 160}, {40, 120, 160}, {40, 160, 160}}, 12)};
  const auto learned = learnColor(samples, {image});
  ASSERT_TRUE(learned);
  EXPECT_NEAR(learned->assessment.targetShare, 0.25, 1e-9);
  EXPECT_NEAR(learned->assessment.separability, 0.4, 1e-9);
  EXPECT_EQ(learned->assessment.backgroundShare, 0.0);
  EXPECT_TRUE(learned->assessment.missesTarget());
  ASSERT_TRUE(learned->assessment.backgroundShareOfFullRange);
  EXPECT_NEAR(*learned->assessment.backgroundShareOfFullRange, 0.75, 1e-9);

  // A range by hand that holds the target: nothing is missed, much of the room is hit.
  const auto all = assessColor(ColorRange{0.0, 60.0, 0.1, 1.0, 0.1, 1.0}, samples, {image});
  EXPECT_FALSE(all.missesTarget());
  EXPECT_FALSE(all.backgroundShareOfFullRange);
  EXPECT_NEAR(all.backgroundShare, 0.75, 1e-9);
}

// Every tenth pixel in both directions has the target's color: 768 pixels beside a target of 1000
// make F1 = 2000 / 2768, rounded 72. None of them is a thing, and nothing of the target is missed:
// there is no advice to give.
TEST(ColorAssessment, SpecklesInTheRoomAskForNothing) {
  const BgrColor red{40, 40, 160};
  cv::Mat image(240, 320, CV_8UC3, cv::Scalar(200, 60, 20));
  for (int y = 0; y < image.rows; y += 10) {
    for (int x = 0; x < image.cols; x += 10) {
      image.at<cv::Vec3b>(y, x) = {red[0], red[1], red[2]};
    }
  }
  const auto assessment =
      assessColor(ColorRange{350.0, 10.0, 0.1, 1.0, 0.1, 1.0}, {sampleOf({red}, 1000)}, {image});
  EXPECT_EQ(assessment.score(), 72);
  EXPECT_FALSE(assessment.missesTarget());
  EXPECT_TRUE(assessment.distractors.empty());
  EXPECT_EQ(assessment.suggestion, ColorSuggestion::None);
}

// 12 of 76,800 pixels are a speck, of which a range matches next to nothing.
TEST(ColorAssessment, ASpeckIsNoThing) {
  const cv::Mat image = room({});
  std::vector<BgrColor> colors;
  for (int x = 0; x < 320; x += 8) { // grays as everywhere
    const auto& pixel = image.at<cv::Vec3b>(100, x);
    colors.push_back({pixel[0], pixel[1], pixel[2]});
  }
  colors.push_back({10, 10, 200}); // and one of another color, which the range is for
  const auto learned = learnColor({sampleOf(colors, 12)}, {image});
  ASSERT_TRUE(learned);
  EXPECT_LT(learned->assessment.separability, 0.1);
  EXPECT_LT(learned->assessment.targetShare, 0.1);
  EXPECT_EQ(learned->assessment.suggestion, ColorSuggestion::ClickMore);
}

// Anywhere on a ball, the region is the ball: to within a rim of one pixel, which on a disc of 15
// pixels is 13 % of its area.
TEST(ColorSample, TheRegionIsTheWholeShadedBall) {
  const cv::Point center{120, 100};
  const cv::Mat image = room({{center, kPink}});
  for (const cv::Point off : {cv::Point{0, 0}, {8, 6}, {-9, 3}, {2, 11}, {-5, -6}}) {
    EXPECT_GT(f1(growRegion(image, center + off), disc(center)), 0.87) << off;
  }
}

TEST(ColorSample, KeepsItsPlaceAndAtMostSoManyColors) {
  const cv::Mat image = room({{{120, 100}, kPink}});
  const ColorSample sample = clickAt(image, {122, 101});
  EXPECT_EQ(sample.x, 122);
  EXPECT_EQ(sample.colors.size(), ColorSample::kMaxColors);
  EXPECT_NEAR(sample.areaPx, std::numbers::pi * kRadius * kRadius,
              0.13 * std::numbers::pi * kRadius * kRadius);
}

TEST(ColorSample, ABoxBoundsIt) {
  const cv::Mat image = room({{{120, 100}, kPink}});
  ColorSample place;
  place.x = 115;
  place.y = 95;
  place.width = 10;
  place.height = 8;
  EXPECT_LE(takeSample(image, place)->areaPx, 80);
}

TEST(ColorSample, PlacesOutsideAreRefused) {
  const cv::Mat image = room({});
  ColorSample place;
  place.x = 320.0;
  EXPECT_EQ(takeSample(image, place).error().field, "pixel");
  place.x = std::nan("");
  EXPECT_EQ(takeSample(image, place).error().field, "pixel");
  place = {.x = 310.0, .width = 20.0, .height = 5.0};
  EXPECT_EQ(takeSample(image, place).error().field, "box");
  EXPECT_EQ(takeSample(cv::Mat(), {}).error().field, "image");
}

TEST(ColorLearning, OneClickFindsTheBallElsewhere) {
  const cv::Mat image = room({{{120, 100}, kPink}});
  const auto learned = learnColor({clickAt(image, {118, 97})}, {image});
  ASSERT_TRUE(learned);
  EXPECT_TRUE(checkColorRange(learned->range));
  const cv::Mat later = room({{{250, 180}, kPink}}, 2);
  EXPECT_GT(f1(matchImage(later, ColorClassifier(learned->range)), disc({250, 180})), 0.9);
  EXPECT_GT(learned->assessment.separability, 0.9);
  EXPECT_LT(learned->assessment.backgroundShare, 1e-3);
  EXPECT_TRUE(learned->assessment.distractors.empty());
  EXPECT_EQ(learned->assessment.suggestion, ColorSuggestion::None);
}

TEST(ColorLearning, RedWrapsThroughZero) {
  const cv::Mat image = room({{{120, 100}, cv::Scalar(50, 50, 220)}});
  const auto learned = learnColor({clickAt(image, {120, 100})}, {image});
  ASSERT_TRUE(learned);
  EXPECT_GT(learned->range.hueMin, learned->range.hueMax);
}

TEST(ColorLearning, ATwinIsNamedWhereItIs) {
  const cv::Mat image = room({{{120, 100}, kPink}, {{290, 30}, kPink}});
  const auto learned = learnColor({clickAt(image, {120, 100})}, {cv::Mat(), image, image});
  ASSERT_TRUE(learned) << "a click on camera 0, which has no image now";
  auto sample = clickAt(image, {120, 100});
  sample.camera = 1;
  const auto seen = learnColor({sample}, {cv::Mat(), image});
  ASSERT_EQ(seen->assessment.distractors.size(), 1U);
  const DistractorRegion& twin = seen->assessment.distractors.front();
  EXPECT_EQ(twin.camera, 1);
  EXPECT_EQ(twin.horizontalThird, HorizontalThird::Right);
  EXPECT_EQ(twin.verticalThird, VerticalThird::Top);
  EXPECT_EQ(twin.color, ColorName::Pink);
  EXPECT_TRUE(twin.box.contains({290, 30}));
  EXPECT_EQ(seen->assessment.suggestion, ColorSuggestion::FollowAll);
  EXPECT_EQ(seen->assessment.similarObjectCount, 2);
}

TEST(ColorLearning, WhatIsMuchLargerIsNoTwin) {
  cv::Mat image = room({{{120, 100}, kPink}});
  image(cv::Rect(200, 0, 120, 220)).setTo(kPink);
  const auto learned = learnColor({clickAt(image, {120, 100})}, {image});
  ASSERT_TRUE(learned);
  EXPECT_EQ(learned->assessment.similarObjectCount, 1);
  EXPECT_NE(learned->assessment.suggestion, ColorSuggestion::FollowAll);
}

TEST(ColorLearning, WhatIsExcludedMatchesLess) {
  const cv::Scalar orange(60, 110, 215);
  const cv::Scalar red(60, 70, 215);
  const cv::Mat image = room({{{120, 100}, red}});
  const cv::Mat other = room({{{60, 60}, orange}}, 3);
  const ColorSample target = clickAt(image, {120, 100});
  const ColorSample excluded = clickAt(other, {60, 60}, true);
  const auto matching = [&](const std::vector<ColorSample>& samples) {
    return cv::countNonZero(
        matchImage(other, ColorClassifier(learnColor(samples, {image})->range)));
  };
  // They differ by 20 degrees of hue, and in the dark by little more than the noise.
  EXPECT_LT(matching({target, excluded}), matching({target}) / 2);
  EXPECT_LT(matching({target, excluded}), 0.2 * std::numbers::pi * kRadius * kRadius);
  EXPECT_FALSE(learnColor({excluded}, {image})) << "nothing to learn";
}

TEST(ColorLearning, TheVerdictFollowsTheRange) {
  const cv::Mat image = room({{{120, 100}, kPink}});
  const ColorSample sample = clickAt(image, {120, 100});
  const ColorAssessment all = assessColor(ColorRange{0.0, 360.0}, {sample}, {image});
  EXPECT_NEAR(all.backgroundShare, 1.0, 1e-3);
  EXPECT_LT(all.separability, 0.05);
  EXPECT_FALSE(all.isGood());
  ColorAssessment good;
  good.separability = 0.9;
  EXPECT_TRUE(good.isGood());
  good.isTargetKnown = false; // then there is no score
  EXPECT_FALSE(good.isGood());
  const ColorAssessment none = assessColor(ColorRange{100.0, 110.0, 0.5}, {sample}, {image});
  EXPECT_EQ(none.separability, 0.0);
  EXPECT_EQ(none.suggestion, ColorSuggestion::AddSamples);
}

TEST(ColorHistogram, SharesSumToOne) {
  const ColorHistogram histogram = histogramOf({room({{{120, 100}, kPink}}), cv::Mat()});
  const auto sum = [](const auto& bins) { return std::accumulate(bins.begin(), bins.end(), 0.0); };
  EXPECT_NEAR(sum(histogram.saturation), 1.0, 1e-9);
  EXPECT_NEAR(sum(histogram.intensity), 1.0, 1e-9);
  EXPECT_LE(sum(histogram.hue), 1.0 + 1e-9);
}

} // namespace
} // namespace dewpoint::tests
