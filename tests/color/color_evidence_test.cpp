// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/color_evidence.h"
#include "tests/color/red_samples.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace dewpoint::tests {
namespace {

const BgrColor kDarkRed{20, 20, 100};
const BgrColor kGreen{40, 160, 60};
const cv::Scalar kWall(120, 120, 120);

/// A wall of 40 x 30 pixels, 1200 in all, with squares on it.
cv::Mat wallWith(const std::vector<std::pair<cv::Rect, BgrColor>>& squares) {
  cv::Mat image(30, 40, CV_8UC3, kWall);
  for (const auto& [place, color] : squares) {
    image(place).setTo(cv::Scalar(color[0], color[1], color[2]));
  }
  return image;
}

const cv::Rect kSquare(10, 8, 10, 10);

/// What a click on the square finds: a region is grown in the image after a median of 3 x 3, which
/// takes the corners (4 of their 9 neighbors are of the square).
constexpr int kRegion = 100 - 4;

/// That region, grown by an ellipse of 3 pixels all around (rows of 1, 5, 7, 7, 7, 5 and 1 pixels):
/// 16 pixels in each of its 10 rows, and 14, 12 and 8 in those above and below.
constexpr int kWidened = 10 * 16 + 2 * (14 + 12 + 8);

ColorSample clickOn(const cv::Mat& image, cv::Point at, int camera = 0) {
  ColorSample place;
  place.camera = camera;
  place.x = at.x;
  place.y = at.y;
  return *takeSample(image, place);
}

double weightOf(const std::vector<WeightedHsiColor>& colors, const BgrColor& color) {
  const Hsi wanted = hsiFromBgr(color[0], color[1], color[2]);
  double weight = 0.0;
  for (const WeightedHsiColor& cell : colors) {
    weight += std::abs(cell.color.intensity - wanted.intensity) < 1e-6 &&
                      std::abs(cell.color.saturation - wanted.saturation) < 1e-6
                  ? cell.weight
                  : 0.0;
  }
  return weight;
}

// Samples of 100 and 300 pixels: a target of 200 on average. Each click counts half of it, however
// large its region and however many colors were kept of it.
TEST(ColorEvidence, EveryClickCountsTheSame) {
  const ColorEvidence evidence = collectColorEvidence(
      {sampleOf({kRed}, 100), sampleOf({kDarkRed, kDarkRed, kRed, kRed}, 300)}, {});
  EXPECT_EQ(evidence.targetAreaPx, 200.0);
  EXPECT_NEAR(evidence.targetWeight, 200.0, 1e-9);
  EXPECT_NEAR(weightOf(evidence.targetColors, kRed), 100.0 + 50.0, 1e-9);
  EXPECT_NEAR(weightOf(evidence.targetColors, kDarkRed), 50.0, 1e-9);
  EXPECT_EQ(evidence.restWeight, 0.0);
  EXPECT_EQ(evidence.targetShareOfImage, 0.0);
  EXPECT_TRUE(evidence.targetMasks.empty());
  EXPECT_EQ(evidence.typicalColor, kRed); // of five colors three are red
}

// What is excluded says nothing about the target's size, and weighs as much as the whole target.
TEST(ColorEvidence, AnExcludedSampleIsAsMuchBackgroundAsATargetIsLarge) {
  const ColorEvidence evidence =
      collectColorEvidence({sampleOf({kRed}, 100), sampleOf({kGreen}, 5000, true)}, {});
  EXPECT_EQ(evidence.targetAreaPx, 100.0);
  EXPECT_NEAR(evidence.targetWeight, 100.0, 1e-9);
  EXPECT_NEAR(weightOf(evidence.restColors, kGreen), 100.0, 1e-9);
  EXPECT_EQ(evidence.typicalColor, kRed);
}

TEST(ColorEvidence, WithoutASampleAllIsRest) {
  const ColorEvidence evidence = collectColorEvidence({}, {wallWith({{kSquare, kRed}})});
  EXPECT_TRUE(evidence.targetColors.empty());
  EXPECT_EQ(evidence.targetWeight, 0.0);
  EXPECT_EQ(evidence.restWeight, 1200.0);
  ASSERT_EQ(evidence.targetMasks.size(), 1U);
  EXPECT_EQ(cv::countNonZero(evidence.targetMasks[0]), 0);
}

TEST(ColorEvidence, TheClickedRegionAndItsRimAreNoBackground) {
  const cv::Mat image = wallWith({{kSquare, kRed}});
  const ColorSample sample = clickOn(image, {14, 12});
  ASSERT_EQ(sample.areaPx, kRegion);
  const ColorEvidence evidence = collectColorEvidence({sample}, {image});
  EXPECT_EQ(evidence.targetAreaPx, kRegion);
  EXPECT_NEAR(evidence.targetShareOfImage, kRegion / 1200.0, 1e-12);
  EXPECT_EQ(cv::countNonZero(evidence.targetMasks[0]), kWidened);
  EXPECT_EQ(evidence.restWeight, 1200.0 - kWidened);
  EXPECT_EQ(weightOf(evidence.restColors, kRed), 0.0);
}

// Two images show the target once each: it weighs twice its area. The second image has no click;
// the one thing there of the target's color, half as large again, is the target.
TEST(ColorEvidence, InOtherImagesTheOneThingOfItsColorIsTheTarget) {
  const cv::Mat clicked = wallWith({{kSquare, kRed}});
  const cv::Mat other = wallWith({{{20, 5, 15, 10}, kRed}, {{2, 2, 6, 6}, kGreen}});
  const ColorEvidence evidence =
      collectColorEvidence({clickOn(clicked, {14, 12})}, {clicked, other});
  EXPECT_NEAR(evidence.targetWeight, 2.0 * kRegion, 1e-9);
  ASSERT_EQ(evidence.targetMasks.size(), 2U);
  // 15 x 10 pixels, widened likewise: 10 rows of 21, and 21, 19 and 15 above and below.
  constexpr int kOther = 10 * 21 + 2 * (21 + 19 + 15);
  EXPECT_EQ(cv::countNonZero(evidence.targetMasks[1]), kOther);
  EXPECT_EQ(evidence.restWeight, 2.0 * 1200.0 - kWidened - kOther);
  EXPECT_NEAR(weightOf(evidence.restColors, kGreen), 36.0, 1e-9);
}

// 10 x 10 was clicked: what is more than four times, or less than a sixteenth as large, is not it,
// and counts as background of the same color.
TEST(ColorEvidence, AThingOfAnotherSizeIsNotTheTarget) {
  const cv::Mat clicked = wallWith({{kSquare, kRed}});
  const ColorSample sample = clickOn(clicked, {14, 12});
  for (const cv::Rect& place : {cv::Rect(5, 5, 21, 20), cv::Rect(5, 5, 3, 2)}) {
    const ColorEvidence evidence =
        collectColorEvidence({sample}, {clicked, wallWith({{place, kRed}})});
    EXPECT_EQ(cv::countNonZero(evidence.targetMasks[1]), 0) << place;
    EXPECT_NEAR(weightOf(evidence.restColors, kRed), place.area(), 1e-9) << place;
  }
}

// The clicked place shows a wall by now; what was clicked lies elsewhere in the same image.
TEST(ColorEvidence, AClickWhoseThingIsGoneIsLookedForElsewhere) {
  const ColorSample sample = clickOn(wallWith({{kSquare, kRed}}), {14, 12});
  const cv::Mat now = wallWith({{{26, 16, 10, 10}, kRed}});
  const ColorEvidence evidence = collectColorEvidence({sample}, {now});
  const cv::Mat& mask = evidence.targetMasks[0];
  // Found by its color, it keeps its corners.
  constexpr int kWhole = 10 * 16 + 2 * (16 + 14 + 10);
  EXPECT_EQ(cv::countNonZero(mask), kWhole);
  EXPECT_EQ(mask.at<std::uint8_t>(20, 30), 255);
  EXPECT_EQ(mask.at<std::uint8_t>(12, 14), 0);
}

TEST(ColorEvidence, ACameraWithoutAnImageSaysNothing) {
  const cv::Mat image = wallWith({{kSquare, kRed}});
  const ColorEvidence evidence =
      collectColorEvidence({clickOn(image, {14, 12}, 1)}, {cv::Mat(), image});
  ASSERT_EQ(evidence.targetMasks.size(), 2U);
  EXPECT_TRUE(evidence.targetMasks[0].empty());
  EXPECT_EQ(cv::countNonZero(evidence.targetMasks[1]), kWidened);
  EXPECT_NEAR(evidence.targetWeight, kRegion, 1e-9); // one image
}

// Shading makes a thing of one color many: what touches the target and matches the range that was
// found belongs to it.
TEST(ColorEvidence, WithARangeTheRestOfTheThingIsTheTargetToo) {
  const cv::Mat clicked = wallWith({{kSquare, kRed}});
  const ColorSample sample = clickOn(clicked, {14, 12});
  const cv::Mat shaded = wallWith({{{5, 5, 10, 10}, kRed}, {{15, 5, 10, 10}, kDarkRed}});
  const auto typical = collectColorEvidence({sample}, {clicked, shaded});
  EXPECT_NEAR(weightOf(typical.restColors, kDarkRed), 7 * 10, 1e-9); // but for the rim of 3 pixels
  const ColorRange red{340.0, 20.0, 0.2, 1.0, 0.05, 1.0};
  const auto whole = collectColorEvidence({sample}, {clicked, shaded}, red);
  EXPECT_EQ(weightOf(whole.restColors, kDarkRed), 0.0);
}

// What an image shows of a click does not change with the range, and what it has beside the target
// only where the target's mask does. Each case: samples, images, a range, and the steps that were
// left to do when the evidence of the same samples was known of these or of other images.
constexpr ColorRange kRedRange{340.0, 20.0, 0.2, 1.0, 0.05, 1.0};
constexpr ColorRange kGreenRange{100.0, 140.0, 0.2, 1.0, 0.05, 1.0};

std::uint64_t bitsOf(double value) {
  return std::bit_cast<std::uint64_t>(value); // the hue of gray is NaN
}

void expectSameColors(const std::vector<WeightedHsiColor>& colors,
                      const std::vector<WeightedHsiColor>& wanted) {
  ASSERT_EQ(colors.size(), wanted.size());
  for (std::size_t i = 0; i < colors.size(); ++i) {
    EXPECT_EQ(bitsOf(colors[i].color.hueDegrees), bitsOf(wanted[i].color.hueDegrees));
    EXPECT_EQ(bitsOf(colors[i].color.saturation), bitsOf(wanted[i].color.saturation));
    EXPECT_EQ(bitsOf(colors[i].color.intensity), bitsOf(wanted[i].color.intensity));
    EXPECT_EQ(bitsOf(colors[i].weight), bitsOf(wanted[i].weight)) << i;
  }
}

using Steps = std::tuple<int, int, int>; // grown regions, flood fills, counted images

Steps stepsOf(const ColorEvidence& evidence) {
  return {evidence.workCounts.grownRegionCount, evidence.workCounts.floodFillCount,
          evidence.workCounts.countedImageCount};
}

/// The evidence from what is known; all of it is compared with what is collected without.
ColorEvidence fromKnown(const std::vector<ColorSample>& samples, const std::vector<cv::Mat>& images,
                        const ColorRange& range, const ColorEvidence& known) {
  const ColorEvidence evidence = collectColorEvidence(samples, images, range, known);
  const ColorEvidence wanted = collectColorEvidence(samples, images, range);
  expectSameColors(evidence.targetColors, wanted.targetColors);
  expectSameColors(evidence.restColors, wanted.restColors);
  EXPECT_EQ(bitsOf(evidence.targetWeight), bitsOf(wanted.targetWeight));
  EXPECT_EQ(bitsOf(evidence.restWeight), bitsOf(wanted.restWeight));
  EXPECT_EQ(bitsOf(evidence.targetAreaPx), bitsOf(wanted.targetAreaPx));
  EXPECT_EQ(bitsOf(evidence.targetShareOfImage), bitsOf(wanted.targetShareOfImage));
  EXPECT_EQ(evidence.typicalColor, wanted.typicalColor);
  EXPECT_EQ(evidence.typicalRanges, wanted.typicalRanges);
  EXPECT_EQ(evidence.targetMasks.size(), wanted.targetMasks.size());
  for (std::size_t i = 0; i < wanted.targetMasks.size(); ++i) {
    EXPECT_EQ(evidence.targetMasks[i].size(), wanted.targetMasks[i].size());
    EXPECT_TRUE(wanted.targetMasks[i].empty() ||
                cv::norm(evidence.targetMasks[i], wanted.targetMasks[i], cv::NORM_INF) == 0.0);
  }
  return evidence;
}

TEST(KnownColorEvidence, OfOneCameraIsUsedWhole) {
  const cv::Mat image = wallWith({{kSquare, kRed}});
  const std::vector samples{clickOn(image, {14, 12})};
  const ColorEvidence known = collectColorEvidence(samples, {image});
  EXPECT_EQ(stepsOf(known), Steps(1, 0, 1));
  EXPECT_EQ(stepsOf(fromKnown(samples, {image}, kRedRange, known)), Steps(0, 0, 0));
}

TEST(KnownColorEvidence, OfClicksInEveryImageIsUsedWhole) {
  const cv::Mat one = wallWith({{kSquare, kRed}});
  const cv::Mat other = wallWith({{{20, 5, 10, 10}, kRed}});
  const std::vector samples{clickOn(one, {14, 12}), clickOn(other, {24, 9}, 1)};
  const ColorEvidence known = collectColorEvidence(samples, {one, other});
  EXPECT_EQ(stepsOf(known), Steps(2, 0, 2));
  EXPECT_EQ(stepsOf(fromKnown(samples, {one, other}, kRedRange, known)), Steps(0, 0, 0));
}

// Two cameras, one click: only the other image is searched again, and only its pixels are counted
// that the range has made target.
TEST(KnownColorEvidence, OnlyAnImageWithoutAClickIsSearchedAgain) {
  const cv::Mat clicked = wallWith({{kSquare, kRed}});
  const cv::Mat shaded = wallWith({{{5, 5, 10, 10}, kRed}, {{15, 5, 10, 10}, kDarkRed}});
  const std::vector samples{clickOn(clicked, {14, 12})};
  const ColorEvidence known = collectColorEvidence(samples, {clicked, shaded});
  EXPECT_EQ(stepsOf(known), Steps(1, 1, 2));
  const ColorEvidence red = fromKnown(samples, {clicked, shaded}, kRedRange, known);
  EXPECT_EQ(stepsOf(red), Steps(0, 1, 1));
  // A range that adds nothing to the red half; and one after the other.
  EXPECT_EQ(stepsOf(fromKnown(samples, {clicked, shaded}, kGreenRange, known)), Steps(0, 1, 0));
  EXPECT_EQ(stepsOf(fromKnown(samples, {clicked, shaded}, kGreenRange, red)), Steps(0, 1, 1));
}

TEST(KnownColorEvidence, AChangedImageIsReadAgain) {
  const cv::Mat clicked = wallWith({{kSquare, kRed}});
  const cv::Mat other = wallWith({{{20, 5, 15, 10}, kRed}});
  const std::vector samples{clickOn(clicked, {14, 12})};
  const ColorEvidence known = collectColorEvidence(samples, {clicked, other});
  const cv::Mat later = wallWith({{kSquare, kRed}, {{30, 20, 5, 5}, kGreen}});
  EXPECT_EQ(stepsOf(fromKnown(samples, {later, other}, kRedRange, known)), Steps(1, 1, 1));
  // What was clicked has gone: it is searched by the samples' color, then by the range.
  const cv::Mat moved = wallWith({{{26, 16, 10, 10}, kRed}});
  EXPECT_EQ(stepsOf(fromKnown(samples, {moved, other}, kRedRange, known)), Steps(1, 3, 1));
  // The other camera has no image any more; then it is back.
  const ColorEvidence alone = fromKnown(samples, {clicked, cv::Mat()}, kRedRange, known);
  EXPECT_EQ(stepsOf(alone), Steps(0, 0, 1));
  EXPECT_EQ(stepsOf(fromKnown(samples, {clicked, other}, kRedRange, alone)), Steps(0, 2, 1));
  EXPECT_EQ(stepsOf(fromKnown(samples, {clicked}, kRedRange, known)), Steps(0, 0, 1));
}

// The colors of an excluded sample weigh fractions of a pixel, whose sums depend on their order.
TEST(KnownColorEvidence, WithAnExcludedSampleAllIsCountedAgainForTheSameBits) {
  const cv::Mat clicked = wallWith({{kSquare, kRed}, {{25, 20, 10, 9}, kGreen}});
  const cv::Mat shaded = wallWith({{{5, 5, 10, 10}, kRed}, {{15, 5, 10, 10}, kDarkRed}});
  const std::vector samples{
      clickOn(clicked, {14, 12}),
      sampleOf({kGreen, kGreen, kGreen, kDarkRed, kRed, kRed, kDarkRed}, 7, true)};
  const ColorEvidence known = collectColorEvidence(samples, {clicked, shaded});
  EXPECT_EQ(stepsOf(fromKnown(samples, {clicked, shaded}, kRedRange, known)), Steps(0, 1, 2));
  EXPECT_EQ(stepsOf(fromKnown(samples, {clicked, shaded}, kGreenRange, known)), Steps(0, 1, 0));
}

// 7 brightnesses, 5 saturations and 5 hues of each color, whose shares add up to one.
TEST(ColorEvidence, OtherLightKeepsTheWeight) {
  const std::vector<WeightedHsiColor> colors{{{10.0, 0.5, 0.4}, 30.0}, {{200.0, 0.9, 0.7}, 70.0}};
  const auto varied = withLightVariations(colors);
  ASSERT_EQ(varied.size(), 2U * 7U * 5U * 5U);
  double weight = 0.0;
  for (const WeightedHsiColor& cell : varied) {
    weight += cell.weight;
    EXPECT_LE(cell.color.saturation, 1.0);
    EXPECT_LE(cell.color.intensity, 1.0);
    EXPECT_GE(cell.color.hueDegrees, 0.0);
    EXPECT_LT(cell.color.hueDegrees, 360.0);
  }
  EXPECT_NEAR(weight, 100.0, 1e-9);
  // The darkest and palest, 8 degrees before: 0.45 and 0.7 of it, 0.05 * 0.1 * 0.1 of the weight.
  EXPECT_NEAR(varied[0].color.hueDegrees, 2.0, 1e-9);
  EXPECT_NEAR(varied[0].color.saturation, 0.35, 1e-9);
  EXPECT_NEAR(varied[0].color.intensity, 0.18, 1e-9);
  EXPECT_NEAR(varied[0].weight, 30.0 * 0.05 * 0.1 * 0.1, 1e-12);
}

// What may be the target is no background, also when it is collected again with a range.
TEST(ColorEvidence, LeavesOutWhatIsUndecided) {
  const cv::Mat clicked = wallWith({{kSquare, kRed}});
  const cv::Mat other = wallWith({{kSquare, kGreen}});
  cv::Mat undecided = cv::Mat::zeros(other.size(), CV_8UC1);
  undecided(kSquare).setTo(255);
  const std::vector<ColorSample> samples{clickOn(clicked, {15, 13})};
  const ColorEvidence with =
      collectColorEvidence(samples, {clicked, other}, std::nullopt, {{}, undecided});
  EXPECT_EQ(weightOf(with.restColors, kGreen), 0.0);
  EXPECT_GT(weightOf(collectColorEvidence(samples, {clicked, other}).restColors, kGreen), 99.0);
  const ColorRange range{100.0, 140.0, 0.0, 1.0, 0.0, 1.0};
  const ColorEvidence again = collectColorEvidence(samples, {clicked, other}, range, with);
  EXPECT_EQ(weightOf(again.restColors, kGreen), 0.0);
}

} // namespace
} // namespace dewpoint::tests
