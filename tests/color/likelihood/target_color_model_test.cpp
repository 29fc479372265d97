// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/color_evidence.h"
#include "core/color/hsi.h"
#include "core/color/likelihood/target_color_model.h"
#include "tests/color/red_samples.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace dewpoint::tests {
namespace {

const BgrColor kBlue{200, 60, 40};
const BgrColor kGray{120, 120, 120};
const BgrColor kLeafGreen{60, 160, 40};
const ColorRange kEveryColor{0.0, 360.0};
const ColorRange kNarrowRedRange{350.0, 10.0, 0.2, 1.0, 0.1, 0.9};

WeightedHsiColor pixelsOf(const BgrColor& color, double count) {
  return {hsiFromBgr(color[0], color[1], color[2]), count};
}

/// The table of the reference camera.
ColorLikelihood tableOf(const std::vector<WeightedHsiColor>& target,
                        const std::vector<WeightedHsiColor>& rest,
                        const ColorRange& range = kEveryColor, double restPerTarget = 1.0) {
  TargetColorModel model(range);
  model.add(target);
  return model.likelihoodForCamera({}, rest, restPerTarget);
}

int at(const ColorLikelihood& table, const BgrColor& color) {
  return table.logRatioSteps(color[0], color[1], color[2]);
}

// Without evidence the range decides: 1 nat, 16 steps, for what lies in it, as much against what
// does not, and all there is against what lies beyond its limits. Red, orange and green have hues
// of 0, 19 and 129 degrees, the range ends at 10, its limits at 30.
TEST(TargetColorModel, WithoutEvidenceTheRangeDecides) {
  const ColorLikelihood table = tableOf({}, {}, kNarrowRedRange);
  const BgrColor orange{40, 93, 200};
  EXPECT_NEAR(hsiFromBgr(orange[0], orange[1], orange[2]).hueDegrees, 19.0, 0.1);
  EXPECT_EQ(at(table, kRed), 16);
  EXPECT_EQ(at(table, orange), -16);
  EXPECT_EQ(at(table, kLeafGreen), -72);
  EXPECT_EQ(at(table, kGray), -72);
}

// Of the cell with the levels 64 to 71, 64 to 71 and 200 to 207 eight colors are looked at, with
// levels of 66 or 69 and 202 or 205. Each of them that lies in the range adds a quarter to a prior
// of -1 nat, 4 steps to -16.
TEST(TargetColorModel, ACellOnABoundIsInPartInTheRange) {
  int within = 0;
  const ColorRange range{350.0, 10.0, 0.41, 1.0, 0.0, 1.0};
  for (const std::uint8_t b : {66, 69}) {
    for (const std::uint8_t g : {66, 69}) {
      for (const std::uint8_t r : {202, 205}) {
        within += matches(hsiFromBgr(b, g, r), range) ? 1 : 0;
      }
    }
  }
  ASSERT_GT(within, 0);
  ASSERT_LT(within, 8);
  EXPECT_EQ(at(tableOf({}, {}, range), {66, 66, 202}), 4 * within - 16);
}

// 20 pixels count as much as the prior. A color that only the target has says as much as any can,
// 4.5 nats: half of it and half of the prior, 1 nat, are 2.75 nats, 44 steps. One that only the
// rest has: (1 - 4.5) / 2. A color of neither has the prior.
TEST(TargetColorModel, AFewPixelsAndThePriorShareTheDecision) {
  const ColorLikelihood target = tableOf({pixelsOf(kRed, 20.0)}, {});
  EXPECT_EQ(at(target, kRed), 44);
  EXPECT_EQ(at(target, kLeafGreen), 16);
  const ColorLikelihood rest = tableOf({}, {pixelsOf(kRed, 20.0)});
  EXPECT_EQ(at(rest, kRed), -28);
  EXPECT_EQ(at(rest, kLeafGreen), 16);
  // The side with fewer pixels counts.
  const ColorLikelihood both = tableOf({pixelsOf(kRed, 20.0)}, {pixelsOf(kGray, 1e5)});
  EXPECT_EQ(at(both, kRed), 44);
  EXPECT_EQ(at(both, kGray), -28);
  EXPECT_EQ(at(both, kLeafGreen), 16);
}

TEST(TargetColorModel, MoreEvidenceSaysMore) {
  int before = at(tableOf({}, {}), kRed);
  for (const double pixels : {1.0, 5.0, 20.0, 80.0, 500.0, 1e6}) {
    const int now = at(tableOf({pixelsOf(kRed, pixels)}, {}), kRed);
    EXPECT_GT(now, before) << pixels;
    before = now;
  }
  EXPECT_EQ(before, 72);
  for (const double pixels : {10.0, 100.0, 1e3, 1e4, 1e5}) {
    const int now =
        at(tableOf({pixelsOf(kRed, 200.0)}, {pixelsOf(kGray, 1e4), pixelsOf(kRed, pixels)}), kRed);
    EXPECT_LE(now, before) << pixels;
    before = now;
  }
  EXPECT_LT(before, 0);
}

// Nothing between two colors is taken for the target, as an interval of hues would take it.
TEST(TargetColorModel, ATargetMayHaveSeveralColors) {
  const ColorLikelihood table =
      tableOf({pixelsOf(kRed, 300.0), pixelsOf(kBlue, 200.0)}, {pixelsOf(kGray, 1e4)});
  EXPECT_GT(nats(table, kRed), 4.0);
  EXPECT_GT(nats(table, kBlue), 4.0);
  EXPECT_LT(nats(table, kGray), -4.0);
  EXPECT_EQ(at(table, {120, 50, 120}), 16); // the prior
}

// Half of the target and half of the rest are gray: that says hardly anything. A little against the
// target, as other light spreads more of it.
TEST(TargetColorModel, AColorOfBothSaysNothing) {
  const ColorLikelihood table = tableOf({pixelsOf(kRed, 250.0), pixelsOf(kGray, 250.0)},
                                        {pixelsOf(kGray, 5e3), pixelsOf(kLeafGreen, 5e3)});
  EXPECT_NEAR(nats(table, kGray), 0.0, 0.6);
  EXPECT_GT(nats(table, kRed), 4.0);
  EXPECT_LT(nats(table, kLeafGreen), -4.0);
}

// One in a hundred of the rest has the target's color: about ln(100) for it, somewhat less because
// of other light. But where there are a hundred pixels of the rest for each of the target, one is
// as likely as the other.
TEST(TargetColorModel, PixelsCanBeWeighedInsteadOfLikelihoods) {
  const std::vector<WeightedHsiColor> target{pixelsOf(kRed, 600.0)};
  const std::vector<WeightedHsiColor> rest{pixelsOf(kGray, 59400.0), pixelsOf(kRed, 600.0)};
  EXPECT_NEAR(nats(tableOf(target, rest), kRed), std::log(100.0), 0.8);
  EXPECT_NEAR(nats(tableOf(target, rest, kEveryColor, 100.0), kRed), 0.0, 0.8);
}

// From half of the light to a quarter more, paler, and a few degrees of hue to both sides.
TEST(TargetColorModel, OtherLightIsTheTargetToo) {
  const ColorLikelihood table =
      tableOf({pixelsOf(kRed, 500.0)}, {pixelsOf(kGray, 1e4)}, kNarrowRedRange);
  for (const BgrColor& color :
       {BgrColor{20, 20, 100}, BgrColor{32, 32, 160}, BgrColor{50, 50, 250}, BgrColor{56, 56, 168},
        BgrColor{40, 56, 192}, BgrColor{56, 40, 192}}) {
    EXPECT_GT(nats(table, color), TargetColorModel::kPriorLogRatio)
        << int(color[1]) << ' ' << int(color[2]);
  }
  EXPECT_LT(nats(table, kGray), 0.0);
  EXPECT_LT(nats(table, kBlue), 0.0);
}

TEST(TargetColorModel, NothingBeyondTheLimitsIsTheTarget) {
  std::vector<WeightedHsiColor> target;
  for (const BgrColor& color : {kRed, kBlue, kGray, kLeafGreen}) {
    target.push_back(pixelsOf(color, 1e4));
  }
  const ColorLikelihood table = tableOf(target, {}, kNarrowRedRange);
  const ColorRange limits = TargetColorModel::limitsOf(kNarrowRedRange);
  int inside = 0;
  for (int b = 4; b < 256; b += 8) { // the middle of each cell
    for (int g = 4; g < 256; g += 8) {
      for (int r = 4; r < 256; r += 8) {
        const BgrColor color{static_cast<std::uint8_t>(b), static_cast<std::uint8_t>(g),
                             static_cast<std::uint8_t>(r)};
        if (matches(hsiFromBgr(color[0], color[1], color[2]), limits)) {
          ++inside;
        } else {
          ASSERT_EQ(at(table, color), -72) << b << ' ' << g << ' ' << r;
        }
      }
    }
  }
  EXPECT_GT(inside, 100);
  EXPECT_GT(nats(table, kRed), 4.0);
}

TEST(TargetColorModel, LimitsCanBeOpened) {
  TargetColorModel model(kNarrowRedRange, kEveryColor);
  model.add({pixelsOf(kRed, 500.0), pixelsOf(kBlue, 500.0)});
  const ColorLikelihood table = model.likelihoodForCamera({}, {});
  EXPECT_GT(nats(table, kBlue), 4.0);
  EXPECT_EQ(at(table, kLeafGreen), -16); // not the lowest, but the prior
}

TEST(TargetColorModel, LimitsAreTheRangeAndAMargin) {
  EXPECT_EQ(TargetColorModel::limitsOf({350.0, 10.0, 0.25, 0.75, 0.25, 0.5}),
            (ColorRange{330.0, 30.0, 0.25 - TargetColorModel::kSaturationMargin,
                        0.75 + TargetColorModel::kSaturationMargin,
                        0.25 - TargetColorModel::kIntensityMargin,
                        0.5 + TargetColorModel::kIntensityMargin}));
  EXPECT_EQ(TargetColorModel::limitsOf({5.0, 350.0, 0.05, 0.95, 0.05, 0.95}), kEveryColor);
  EXPECT_EQ(TargetColorModel::limitsOf({10.0, 335.0}).hueMax, 360.0);
  EXPECT_EQ(TargetColorModel::limitsOf({10.0, 320.0}), (ColorRange{350.0, 340.0}));
  EXPECT_EQ(TargetColorModel::limitsOf(kEveryColor), kEveryColor);
  EXPECT_TRUE(checkColorRange(TargetColorModel::limitsOf(kNarrowRedRange)));
}

// A camera that shows blue half again as bright and red a fifth darker: what is (40, 40, 200) in
// the reference camera is (60, 40, 160) there, for the evidence and for the range.
TEST(TargetColorModel, ACameraSeesThroughItsGain) {
  const ColorGain gain{1.5, 1.0, 0.8};
  TargetColorModel model(kNarrowRedRange);
  model.add({pixelsOf(kRed, 500.0)});
  const int reference = at(model.likelihoodForCamera({}, {}), kRed);
  EXPECT_EQ(reference, 70); // (20 * 1 + 500 * 4.5) / 520 nats, 69.8 steps
  EXPECT_EQ(at(model.likelihoodForCamera(gain, {}), {60, 40, 160}), reference);

  TargetColorModel seenThere(kNarrowRedRange);
  seenThere.add({pixelsOf({60, 40, 160}, 500.0)}, gain);
  const ColorLikelihood learnedThere = seenThere.likelihoodForCamera({}, {});
  const ColorLikelihood learnedHere = model.likelihoodForCamera({}, {});
  for (int b = 4; b < 256; b += 8) {
    for (int g = 4; g < 256; g += 8) {
      for (int r = 4; r < 256; r += 8) {
        const BgrColor color{static_cast<std::uint8_t>(b), static_cast<std::uint8_t>(g),
                             static_cast<std::uint8_t>(r)};
        ASSERT_LE(std::abs(at(learnedThere, color) - at(learnedHere, color)), 1)
            << b << ' ' << g << ' ' << r;
      }
    }
  }
}

// Gray (100) in a camera that shows red half as bright is (100, 100, 200) in the reference camera,
// red; in a camera that shows blue and green half as bright it is (200, 200, 100) there, cyan.
TEST(TargetColorModel, TheRangeIsMeantInTheReferenceCamera) {
  const TargetColorModel model(kNarrowRedRange);
  EXPECT_EQ(at(model.likelihoodForCamera({}, {}), {100, 100, 100}), -72);
  EXPECT_EQ(at(model.likelihoodForCamera({1.0, 1.0, 0.5}, {}), {100, 100, 100}), 16);
  EXPECT_EQ(at(model.likelihoodForCamera({0.5, 0.5, 1.0}, {}), {100, 100, 100}), -72);
}

// A channel that a gain would lift above 255 is cut off.
TEST(TargetColorModel, ABrightCameraCutsColorsOff) {
  TargetColorModel model(kEveryColor);
  model.add({pixelsOf(kRed, 500.0)});
  EXPECT_GT(nats(model.likelihoodForCamera({2.0, 2.0, 2.0}, {}), {80, 80, 255}), 4.0);
}

TEST(TargetColorModel, LearnsFromTheEvidenceOfSamples) {
  ColorEvidence evidence;
  EXPECT_EQ(restPixelsPerTargetPixel(evidence), 1.0);
  EXPECT_TRUE(learnLikelihood(evidence, kNarrowRedRange) == tableOf({}, {}, kNarrowRedRange));
  evidence.targetColors = {pixelsOf(kRed, 100.0)};
  evidence.targetWeight = 100.0;
  EXPECT_EQ(restPixelsPerTargetPixel(evidence), 1.0);
  evidence.restColors = {pixelsOf(kGray, 1200.0)};
  evidence.restWeight = 1200.0;
  EXPECT_EQ(restPixelsPerTargetPixel(evidence), 12.0);
  EXPECT_TRUE(learnLikelihood(evidence, kNarrowRedRange, 12.0) ==
              tableOf(evidence.targetColors, evidence.restColors, kNarrowRedRange, 12.0));
}

} // namespace
} // namespace dewpoint::tests
