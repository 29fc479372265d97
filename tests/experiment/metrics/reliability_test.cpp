// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/reliability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace dewpoint::tests {
namespace {

// Two bins. [0, 0.5): 0.1 and 0.3, one of them happened: mean 0.2, frequency 1/2, difference 0.3.
// [0.5, 1]: 0.5, 0.9 and 1.0, all happened: mean 0.8, frequency 1, difference 0.2.
// Error 2/5 * 0.3 + 3/5 * 0.2 = 0.24. Brier: (0.01 + 0.49 + 0.25 + 0.01 + 0) / 5 = 0.152.
TEST(Reliability, HandWorked) {
  const std::vector<Forecast> forecasts{
      {0.1, false}, {0.3, true}, {0.5, true}, {0.9, true}, {1.0, true}};
  const Reliability result = computeReliability(forecasts, 2);
  ASSERT_EQ(result.bins.size(), 2U);
  EXPECT_EQ(result.bins[0].forecastCount, 2);
  EXPECT_DOUBLE_EQ(result.bins[0].meanProbability, 0.2);
  EXPECT_DOUBLE_EQ(result.bins[0].observedFrequency, 0.5);
  EXPECT_EQ(result.bins[1].forecastCount, 3);
  EXPECT_DOUBLE_EQ(result.bins[1].meanProbability, 0.8);
  EXPECT_DOUBLE_EQ(result.bins[1].observedFrequency, 1.0);
  EXPECT_NEAR(result.expectedCalibrationError, 0.24, 1e-15);
  EXPECT_NEAR(result.maxCalibrationError, 0.3, 1e-15);
  EXPECT_NEAR(result.brierScore, 0.152, 1e-15);
}

// 0.75 stated, three of four happened.
TEST(Reliability, CalibratedIsZero) {
  const std::vector<Forecast> forecasts{{0.75, true}, {0.75, true}, {0.75, false}, {0.75, true}};
  EXPECT_EQ(computeReliability(forecasts).expectedCalibrationError, 0.0);
}

TEST(Reliability, EmptyBinsAndUnusableForecasts) {
  const std::vector<Forecast> forecasts{
      {std::numeric_limits<double>::quiet_NaN(), true}, {1.5, true}, {-0.1, true}, {0.0, false}};
  const Reliability result = computeReliability(forecasts);
  EXPECT_EQ(result.unusableForecastCount, 3);
  EXPECT_EQ(result.forecastCount, 1);
  EXPECT_EQ(result.expectedCalibrationError, 0.0);
  EXPECT_TRUE(std::isnan(result.bins[5].observedFrequency));
  EXPECT_EQ(result.bins.size(), 10U);
  EXPECT_TRUE(std::isnan(computeReliability({}).expectedCalibrationError));
}

} // namespace
} // namespace dewpoint::tests
