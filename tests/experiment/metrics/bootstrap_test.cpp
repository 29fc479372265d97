// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"
#include "core/experiment/metrics/bootstrap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace dewpoint::tests {
namespace {

using Runs = std::vector<std::vector<double>>;

TEST(Bootstrap, Statistics) {
  const std::vector<double> values{1.0, 2.0, 3.0, 10.0};
  EXPECT_EQ(meanOf(values), 4.0);
  EXPECT_EQ(medianOf(values), 2.5);
  EXPECT_NEAR(p95Of(values), 3.0 + 0.85 * 7.0, 1e-14); // place 0.95 * 3 = 2.85
}

TEST(Bootstrap, EqualValuesHaveNoSpread) {
  const Interval result = bootstrapInterval(Runs{{2.0}, {2.0, 2.0}, {2.0}}, medianOf);
  EXPECT_EQ(result.value, 2.0);
  EXPECT_EQ(result.low, 2.0);
  EXPECT_EQ(result.high, 2.0);
}

// Four runs of one value each, 0 0 1 1: a resample's mean is 0, 1/4, 1/2, 3/4, 1 with probabilities
// 1/16, 4/16, 6/16, 4/16, 1/16, so the 10 % and 90 % points are 1/4 and 3/4. As two runs of two
// values the mean is 0, 1/2, 1 with 1/4, 1/2, 1/4: they are 0 and 1.
TEST(Bootstrap, RunsAreDrawnWhole) {
  const BootstrapSetup setup{2000, 0.8, 1};
  const Interval independent = bootstrapInterval(Runs{{0.0}, {0.0}, {1.0}, {1.0}}, meanOf, setup);
  EXPECT_EQ(independent.value, 0.5);
  EXPECT_EQ(independent.low, 0.25);
  EXPECT_EQ(independent.high, 0.75);
  const Interval clustered = bootstrapInterval(Runs{{0.0, 0.0}, {1.0, 1.0}}, meanOf, setup);
  EXPECT_EQ(clustered.value, 0.5);
  EXPECT_EQ(clustered.low, 0.0);
  EXPECT_EQ(clustered.high, 1.0);
}

// Mean of 400 standard normal numbers (seed 5): theory says 1.96 / sqrt(400) = 0.098 to each side.
// The margin of 15 % covers the sample's own standard deviation (1 / sqrt(800) = 3.5 %) and the
// noise of 2,000 resamples (about 2 % in each bound).
TEST(Bootstrap, AgreesWithNormalTheory) {
  const RandomStream random(5, 0, 0, RandomPurpose::Noise);
  Runs runs;
  for (std::uint32_t k = 0; k < 400; ++k)
    runs.push_back({random.normal4(k)[0]});
  const Interval result = bootstrapInterval(runs, meanOf);
  EXPECT_NEAR(result.value - result.low, 0.098, 0.015);
  EXPECT_NEAR(result.high - result.value, 0.098, 0.015);
}

TEST(Bootstrap, OneSeedGivesTheSameBitsAndAnotherDoesNot) {
  Runs runs;
  for (int k = 0; k < 20; ++k)
    runs.push_back({std::sin(k), std::cos(3.0 * k)});
  const Interval first = bootstrapInterval(runs, meanOf);
  const Interval again = bootstrapInterval(runs, meanOf);
  EXPECT_EQ(first.low, again.low);
  EXPECT_EQ(first.high, again.high);
  EXPECT_NE(first.low, bootstrapInterval(runs, meanOf, {2000, 0.95, 2}).low);
}

TEST(Bootstrap, EmptyRuns) {
  EXPECT_TRUE(std::isnan(bootstrapInterval({}, meanOf).value));
  EXPECT_TRUE(std::isnan(bootstrapInterval(Runs{{}, {}}, meanOf).low));
  const Interval some = bootstrapInterval(Runs{{}, {3.0}}, meanOf);
  EXPECT_EQ(some.low, 3.0);
  EXPECT_EQ(some.high, 3.0);
}

// 0 of 10: low 0, high z² / (n + z²) = 3.841459 / 13.841459 = 0.277533. 5 of 10: center 1/2, half
// z / (1 + z² / 10) * sqrt(0.25 / 10 + z² / 400) = 1.959964 / 1.384146 * sqrt(0.034604) = 0.263407.
TEST(Wilson, HandWorked) {
  const Interval none = wilsonInterval({0, 10});
  EXPECT_EQ(none.value, 0.0);
  EXPECT_NEAR(none.low, 0.0, 1e-15);
  EXPECT_NEAR(none.high, 0.277533, 1e-6);
  const Interval half = wilsonInterval({5, 10});
  EXPECT_EQ(half.value, 0.5);
  EXPECT_NEAR(half.low, 0.5 - 0.263407, 1e-5);
  EXPECT_NEAR(half.high, 0.5 + 0.263407, 1e-5);
  const Interval all = wilsonInterval({1000, 1000});
  EXPECT_NEAR(all.low, 1000.0 / 1003.841459, 1e-6); // the mirror image of 0 of 1000
  EXPECT_NEAR(all.high, 1.0, 1e-15);
}

TEST(Wilson, WithoutTrialsAnythingIsPossible) {
  const Interval result = wilsonInterval({0, 0});
  EXPECT_TRUE(std::isnan(result.value));
  EXPECT_EQ(result.low, 0.0);
  EXPECT_EQ(result.high, 1.0);
}

} // namespace
} // namespace dewpoint::tests
