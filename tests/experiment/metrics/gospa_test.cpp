// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/gospa.h"
#include "tests/base/not_a_number.h"
#include "tests/experiment/metrics/track_frames.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dewpoint::tests {
namespace {

const GospaSetup kUnit{1.0, 2.0}; // cutoff 1 m, p = 2: a missed or false target costs 1/2

TEST(Gospa, EmptySetsAreEqual) {
  const Gospa result = computeGospa(frameOnAxis({}, {}), kUnit);
  EXPECT_EQ(result.distance, 0.0);
  EXPECT_EQ(result.missedTargetCount + result.falseTargetCount, 0);
}

// One pair 0.3 apart, one truth missed: 0.09 + 1/2 = 0.59.
TEST(Gospa, OneFoundOneMissed) {
  const Gospa result = computeGospa(frameOnAxis({{1, 0.0}, {2, 10.0}}, {{1, 0.3}}), kUnit);
  EXPECT_NEAR(result.localizationCost, 0.09, 1e-15);
  EXPECT_EQ(result.missedTargetCost, 0.5);
  EXPECT_EQ(result.falseTargetCost, 0.0);
  EXPECT_EQ(result.missedTargetCount, 1);
  EXPECT_NEAR(result.distance, std::sqrt(0.59), 1e-15);
}

// The other way round: three estimates of one truth. The nearest counts (0.1² = 0.01), two are
// false: 0.01 + 1 = 1.01.
TEST(Gospa, UnbalancedTowardsFalse) {
  const Gospa result =
      computeGospa(frameOnAxis({{1, 0.0}}, {{1, 0.3}, {2, -0.1}, {3, 5.0}}), kUnit);
  EXPECT_NEAR(result.localizationCost, 0.01, 1e-15);
  EXPECT_EQ(result.falseTargetCount, 2);
  EXPECT_EQ(result.falseTargetCost, 1.0);
  EXPECT_NEAR(result.distance, std::sqrt(1.01), 1e-15);
}

// A pair 1.5 apart is no pair: 1/2 + 1/2 = 1. The same at the cutoff itself.
TEST(Gospa, BeyondTheCutoffIsMissedAndFalse) {
  for (const double x : {1.0, 1.5}) {
    const Gospa result = computeGospa(frameOnAxis({{1, 0.0}}, {{1, x}}), kUnit);
    EXPECT_EQ(result.distance, 1.0);
    EXPECT_EQ(result.localizationCost, 0.0);
    EXPECT_EQ(result.missedTargetCount, 1);
    EXPECT_EQ(result.falseTargetCount, 1);
  }
}

// Truths at 0 and 1, estimates at 0.6 and 1.5. Both paired: 0.36 + 0.25 = 0.61. The nearest pair
// alone, 1 with 0.6: 0.16 + 1/2 + 1/2 = 1.16. The least counts.
TEST(Gospa, PairsForTheSumNotForTheNearest) {
  const Gospa result = computeGospa(frameOnAxis({{1, 0.0}, {2, 1.0}}, {{1, 0.6}, {2, 1.5}}), kUnit);
  EXPECT_NEAR(result.distance, std::sqrt(0.61), 1e-15);
}

// p = 1, cutoff 2: 0.3 + 2/2 for the missed one = 1.3.
TEST(Gospa, OrderOne) {
  const Gospa result = computeGospa(frameOnAxis({{1, 0.0}, {2, 10.0}}, {{1, 0.3}}), {2.0, 1.0});
  EXPECT_NEAR(result.distance, 1.3, 1e-15);
}

TEST(Gospa, AnEstimateThatIsNoNumberIsFalseAndItsTruthMissed) {
  const Gospa result = computeGospa(frameOnAxis({{1, 0.0}}, {{1, kNotANumber}}), kUnit);
  EXPECT_EQ(result.missedTargetCount, 1);
  EXPECT_EQ(result.falseTargetCount, 1);
  EXPECT_EQ(result.distance, 1.0); // sqrt(1/2 + 1/2)
}

// Frames with distance² 0.09 and 0.5: mean of the distances (0.3 + sqrt(0.5)) / 2, root of the mean
// square sqrt(0.295), of which 0.045 localization and 0.25 missed.
TEST(Gospa, Averages) {
  const std::vector<TrackFrame> frames{frameOnAxis({{1, 0.0}}, {{1, 0.3}}),
                                       frameOnAxis({{1, 0.0}}, {})};
  const GospaAverage result = averageGospa(frames, kUnit);
  EXPECT_NEAR(result.mean, (0.3 + std::sqrt(0.5)) / 2.0, 1e-15);
  EXPECT_NEAR(result.powerMean, std::sqrt(0.295), 1e-15);
  EXPECT_NEAR(result.localizationCost, 0.045, 1e-15);
  EXPECT_EQ(result.missedTargetCost, 0.25);
  EXPECT_EQ(result.missedTargetsPerFrame, 0.5);
  EXPECT_EQ(result.falseTargetsPerFrame, 0.0);
  EXPECT_EQ(averageGospa({}, kUnit).mean, 0.0);
}

} // namespace
} // namespace dewpoint::tests
