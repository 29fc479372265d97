// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"
#include "core/color/range_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dewpoint::tests {
namespace {

const double kHueOfGray = std::numeric_limits<double>::quiet_NaN();

WeightedHsiColor cell(double hue, double weight, double saturation = 0.5, double intensity = 0.5) {
  return {{hue, saturation, intensity}, weight};
}

/// Bounds lie half a degree, half a hundredth beyond the outermost colors.
void expectRange(const ColorRange& found, double hueMin, double hueMax, double saturationMin,
                 double saturationMax, double intensityMin, double intensityMax) {
  EXPECT_NEAR(found.hueMin, hueMin, 1e-9);
  EXPECT_NEAR(found.hueMax, hueMax, 1e-9);
  EXPECT_NEAR(found.saturationMin, saturationMin, 1e-9);
  EXPECT_NEAR(found.saturationMax, saturationMax, 1e-9);
  EXPECT_NEAR(found.intensityMin, intensityMin, 1e-9);
  EXPECT_NEAR(found.intensityMax, intensityMax, 1e-9);
}

// Of a target of 60 + 40 pixels the range holds the 60, and 20 of the rest: F1 = 2 * 60 / (100 + 60
// + 20).
TEST(RangeFit, AScoreIsTheF1OfWhatMatches) {
  const std::vector<WeightedHsiColor> target{cell(10, 60), cell(50, 40)};
  const std::vector<WeightedHsiColor> rest{cell(12, 20), cell(200, 500), cell(12, 30, 0.9)};
  const RangeScore score = scoreRange(ColorRange{0.0, 20.0, 0.4, 0.6, 0.0, 1.0}, target, rest);
  EXPECT_EQ(score.targetWeight, 60.0);
  EXPECT_EQ(score.restWeight, 20.0);
  EXPECT_NEAR(score.f1, 120.0 / 180.0, 1e-12);
  EXPECT_EQ(scoreRange(ColorRange{0.0, 20.0}, {}, rest).f1, 0.0);
}

TEST(RangeFit, AloneTheTargetIsHeldTightly) {
  expectRange(fitRange({cell(10, 60, 0.42, 0.3), cell(20, 40, 0.5, 0.7)}, {}), 9.5, 20.5, 0.415,
              0.505, 0.295, 0.705);
}

TEST(RangeFit, BoundsStayWithinColorSpace) {
  const ColorRange found = fitRange({cell(10, 60, 1.0, 1.0), cell(10, 40, 0.0, 0.004)}, {});
  expectRange(found, 9.5, 10.5, 0.0, 1.0, 0.0, 1.0);
}

// Through 180 lies something else: red is around 0.
TEST(RangeFit, HuesGoRoundThroughZero) {
  const ColorRange found = fitRange({cell(355, 50), cell(5, 50)}, {cell(180, 50)});
  EXPECT_NEAR(found.hueMin, 354.5, 1e-9);
  EXPECT_NEAR(found.hueMax, 5.5, 1e-9);
}

// Nothing lies on the other side of the circle, which is no reason to let it through.
TEST(RangeFit, HuesAroundZeroAreHeldTightlyToo) {
  const std::vector<WeightedHsiColor> target{cell(355, 50), cell(5, 50)};
  const ColorRange even = withNarrowestHue(fitRange(target, {}), target, {});
  expectRange(even, 354.5, 5.5, 0.495, 0.505, 0.495, 0.505);
  // Tenths have no exact sum: in another order it is another one.
  const std::vector<WeightedHsiColor> tenths{cell(0, 0.1), cell(10, 0.2), cell(345, 0.3),
                                             cell(350, 0.7)};
  const ColorRange uneven = withNarrowestHue(fitRange(tenths, {}), tenths, {});
  expectRange(uneven, 344.5, 10.5, 0.495, 0.505, 0.495, 0.505);
}

TEST(ShortestHue, LeavesARangeOfEveryHueAndTheOnlyBestOne) {
  const std::vector<WeightedHsiColor> target{cell(10, 50), cell(40, 50)};
  const ColorRange every{0.0, 360.0};
  EXPECT_EQ(withNarrowestHue(every, target, {}), every);
  const ColorRange found = fitRange(target, {cell(200, 50)});
  EXPECT_EQ(withNarrowestHue(found, target, {cell(200, 50)}), found);
}

// Nine tenths of the target at hue 10, one tenth at 40, something else at 25, and much at 200, so
// that no range goes the other way around. Of 50 pixels at 25,
// all of the target costs too much: 2 * 90 / (100 + 90) = 0.95 against 2 * 100 / (100 + 100 + 50) =
// 0.8. Of 5 it does not: 0.95 against 200 / 205 = 0.98.
TEST(RangeFit, APartIsGivenUpWhereItCostsMoreThanItWins) {
  const std::vector<WeightedHsiColor> target{cell(10, 90), cell(40, 10)};
  const ColorRange part = fitRange(target, {cell(25, 50), cell(200, 1000)});
  EXPECT_NEAR(part.hueMin, 9.5, 1e-9);
  EXPECT_NEAR(part.hueMax, 10.5, 1e-9);
  const ColorRange whole = fitRange(target, {cell(25, 5), cell(200, 1000)});
  EXPECT_NEAR(whole.hueMin, 9.5, 1e-9);
  EXPECT_NEAR(whole.hueMax, 40.5, 1e-9);
}

// The same hue and brightness; only how full the color is tells them apart.
TEST(RangeFit, EachAxisCanTellThemApart) {
  const ColorRange fuller = fitRange({cell(100, 80, 0.6), cell(100, 20, 0.8)},
                                     {cell(100, 300, 0.5), cell(100, 300, 0.9)});
  EXPECT_NEAR(fuller.saturationMin, 0.595, 1e-9);
  EXPECT_NEAR(fuller.saturationMax, 0.805, 1e-9);
  const ColorRange brighter =
      fitRange({cell(100, 80, 0.5, 0.3), cell(100, 20, 0.5, 0.4)}, {cell(100, 300, 0.5, 0.2)});
  EXPECT_NEAR(brighter.intensityMin, 0.295, 1e-9);
  EXPECT_NEAR(brighter.intensityMax, 0.405, 1e-9);
}

// Half of the target is gray, which only a range of every hue lets through. With all of it F1 is
// 200 / (200 + rest), with its hue alone 2 * 50 / (100 + 50) = 0.667: 60 pixels of other gray leave
// 0.769, 100 leave 0.667, which is not worth letting every hue through.
TEST(RangeFit, EveryHueIsLetThroughWhereItPays) {
  const std::vector<WeightedHsiColor> target{cell(10, 50), cell(kHueOfGray, 50, 0.0)};
  EXPECT_TRUE(spansEveryHue(fitRange(target, {})));
  EXPECT_TRUE(spansEveryHue(fitRange(target, {cell(kHueOfGray, 60, 0.0)})));
  const ColorRange hue = fitRange(target, {cell(kHueOfGray, 100, 0.0)});
  expectRange(hue, 9.5, 10.5, 0.495, 0.505, 0.495, 0.505);
}

TEST(RangeFit, BlackIsNeverInARange) {
  const ColorRange found = fitRange({cell(10, 50), cell(kHueOfGray, 50, 0.0, 0.0)}, {});
  EXPECT_NEAR(scoreRange(found, {cell(kHueOfGray, 50, 0.0, 0.0)}, {}).targetWeight, 0.0, 1e-12);
  EXPECT_NEAR(found.hueMin, 9.5, 1e-9);
}

/// Colors in random places, as a target in one part of color space and a room all over it.
std::vector<WeightedHsiColor> scattered(std::uint32_t seed, int count, double spread) {
  const RandomStream random(41, seed, 0, RandomPurpose::Noise);
  std::vector<WeightedHsiColor> colors;
  for (int k = 0; k < count; ++k) {
    const auto unit = random.uniform3(static_cast<std::uint32_t>(k));
    const auto more = random.uniform3(static_cast<std::uint32_t>(k + count));
    colors.push_back(cell(std::fmod(340.0 + 180.0 * spread * (unit[0] - 0.5) + 360.0, 360.0),
                          1.0 + std::floor(20.0 * more[0]), 0.5 + spread * (unit[1] - 0.5),
                          0.5 + spread * (unit[2] - 0.5)));
  }
  return colors;
}

// What coordinate ascent promises: no interval of one axis alone is better, on whole degrees and
// hundredths. Every one is tried here.
TEST(RangeFit, NoBoundsOfOneAxisAreBetter) {
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    const auto target = scattered(seed, 12, 0.3);
    const auto rest = scattered(seed + 100, 24, 1.0);
    const ColorRange found = fitRange(target, rest);
    const double reached = scoreRange(found, target, rest).f1;
    double best = 0.0;
    const auto tryOut = [&](const ColorRange& other) {
      best = std::max(best, scoreRange(other, target, rest).f1);
    };
    for (int low = 0; low <= 100; ++low) {
      for (int high = low; high <= 100; ++high) {
        ColorRange other = found;
        other.saturationMin = std::max(0.0, (low - 0.5) / 100.0);
        other.saturationMax = std::min(1.0, (high + 0.5) / 100.0);
        tryOut(other);
        other = found;
        other.intensityMin = std::max(0.0, (low - 0.5) / 100.0);
        other.intensityMax = std::min(1.0, (high + 0.5) / 100.0);
        tryOut(other);
      }
    }
    for (int first = 0; first < 360; ++first) {
      for (int length = 1; length < 360; ++length) {
        ColorRange other = found;
        other.hueMin = std::fmod(first - 0.5 + 360.0, 360.0);
        other.hueMax = std::fmod(first + length - 0.5, 360.0);
        tryOut(other);
      }
    }
    EXPECT_LE(best, reached + 1e-12) << seed;
    EXPECT_GT(reached, 0.3) << seed; // there was something to find
  }
}

} // namespace
} // namespace dewpoint::tests
