// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/color_evidence.h"
#include "core/color/color_learning.h"
#include "core/color/hsi.h"
#include "core/color/sample_colors.h"
#include "tests/color/red_samples.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <vector>

namespace dewpoint::tests {
namespace {

using color::BgrColor;

const BgrColor kDimRed{20, 20, 105};
const BgrColor kSkyBlue{200, 90, 30};
const BgrColor kYellow{40, 200, 220};

ColorSample evenSample(const BgrColor& bgr, bool excluded = false) {
  ColorSample sample;
  sample.isExcluded = excluded;
  sample.areaPx = 400;
  sample.colors.assign(40, bgr);
  return sample;
}

std::vector<std::vector<std::size_t>> groupsOf(const std::vector<ColorSample>& samples) {
  return color::groupSamplesByColor(samples);
}
using Groups = std::vector<std::vector<std::size_t>>;

TEST(ColorsOfSamples, OneColorInOtherLightIsOne) {
  EXPECT_EQ(groupsOf({evenSample(kRed), evenSample(kDimRed)}), (Groups{{0, 1}}));
  EXPECT_EQ(groupsOf({}), Groups{});
}

TEST(ColorsOfSamples, ComeInTheOrderOfTheirFirstSamples) {
  EXPECT_EQ(
      groupsOf({evenSample(kRed), evenSample(kSkyBlue), evenSample(kDimRed), evenSample(kYellow)}),
      (Groups{{0, 2}, {1}, {3}}));
}

TEST(ColorsOfSamples, WhatIsExcludedShowsNoColorOfTheTarget) {
  EXPECT_EQ(groupsOf({evenSample(kSkyBlue, true), evenSample(kRed)}), (Groups{{1}}));
}

TEST(ColorsOfSamples, OfMoreColorsThanThreeTheNearestCountAsOne) {
  const BgrColor orange{30, 120, 235}; // between red and yellow
  const auto groups = groupsOf(
      {evenSample(kRed), evenSample(kSkyBlue), evenSample({60, 190, 60}), evenSample(orange)});
  EXPECT_EQ(groups, (Groups{{0, 3}, {1}, {2}}));
}

/// A ball that is half red and half of another color before a wall; both clicked.
struct Ball {
  cv::Mat image;
  std::vector<ColorSample> clicks;

  explicit Ball(const cv::Scalar& other, const cv::Scalar& wall = {120, 120, 120}) {
    image = cv::Mat(120, 160, CV_8UC3, wall);
    cv::circle(image, {80, 60}, 20, cv::Scalar(40, 40, 200), cv::FILLED);
    cv::ellipse(image, {80, 60}, {20, 20}, 0.0, -90.0, 90.0, other, cv::FILLED);
    for (const int x : {70, 90}) {
      ColorSample place;
      place.x = x;
      place.y = 60;
      clicks.push_back(*takeSample(image, place));
    }
  }
};

bool takes(const ColorRanges& ranges, const BgrColor& bgr) {
  return matches(hsiFromBgr(bgr[0], bgr[1], bgr[2]), ranges);
}

TEST(LearnColor, GivesEachColorOfATargetARange) {
  const Ball ball(cv::Scalar(40, 200, 220), {40, 120, 130}); // yellow, before an olive wall
  const auto learned = learnColor(ball.clicks, {ball.image});
  ASSERT_TRUE(learned);
  ASSERT_EQ(learned->otherRanges.size(), 1U);
  EXPECT_TRUE(takes(learned->range, kRed));
  EXPECT_FALSE(takes(learned->range, kYellow));
  EXPECT_TRUE(takes(learned->otherRanges[0], kYellow));
  EXPECT_FALSE(takes(learned->ranges(), {30, 110, 210})) << "the orange between both";
  EXPECT_FALSE(takes(learned->ranges(), {40, 120, 130}));
  EXPECT_FALSE(learned->assessment.isSampleLeftOut);
  EXPECT_GT(learned->assessment.targetShare, 0.95);
}

TEST(LearnColor, OneRangeIsEnoughWhereNothingElseHasTheColorsBetween) {
  const Ball ball(cv::Scalar(40, 200, 220));
  const auto learned = learnColor(ball.clicks, {ball.image});
  ASSERT_TRUE(learned);
  EXPECT_TRUE(learned->otherRanges.empty());
  EXPECT_TRUE(takes(learned->range, kRed));
  EXPECT_TRUE(takes(learned->range, kYellow));
}

TEST(LearnColor, AColorThatEverythingHasIsLeftOut) {
  const BgrColor olive{40, 120, 130};
  const cv::Mat wall(120, 160, CV_8UC3, cv::Scalar(40, 120, 130));
  const auto learned = learnColor({evenSample(kRed), evenSample(olive)}, {wall});
  ASSERT_TRUE(learned);
  EXPECT_TRUE(learned->otherRanges.empty());
  EXPECT_TRUE(takes(learned->range, kRed));
  EXPECT_FALSE(takes(learned->range, olive));
  EXPECT_TRUE(learned->assessment.isSampleLeftOut);
}

TEST(ColorEvidence, OfSeveralColorsIsDividedTheSameFromWhatWasKnownBefore) {
  const Ball ball(cv::Scalar(40, 200, 220), {40, 120, 130});
  const auto first = color::collectColorEvidence(ball.clicks, {ball.image});
  ASSERT_EQ(first.targetColorsBySampleColor.size(), 2U);
  ASSERT_EQ(first.typicalRanges.size(), 2U);
  const ColorRanges ranges = *learnRanges(first);
  const auto now = color::collectColorEvidence(ball.clicks, {ball.image}, ranges, first);
  const auto anew = color::collectColorEvidence(ball.clicks, {ball.image}, ranges);
  EXPECT_EQ(now.typicalRanges, anew.typicalRanges);
  ASSERT_EQ(now.targetColorsBySampleColor.size(), 2U);
  EXPECT_EQ(now.targetColorsBySampleColor[1].front().weight,
            anew.targetColorsBySampleColor[1].front().weight);
  EXPECT_EQ(now.restWeight, anew.restWeight);
}

} // namespace
} // namespace dewpoint::tests
