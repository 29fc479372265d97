// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/extent_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace dewpoint::tests {
namespace {

// A target whose longest semi-axis is 0.2 m, of the volume of a ball of 0.1 m: a quarter is 0.05 m.
ExtentSample sampleOff(double distance) {
  return {distance, 0.2, 0.1, std::nullopt};
}

TEST(ExtentErrors, NearIsWithinAQuarterOfTheHalfExtent) {
  ExtentSample silent = sampleOff(0.0);
  silent.centroidDistance.reset();
  const std::vector<ExtentSample> samples{sampleOff(0.04), sampleOff(0.05), sampleOff(0.06),
                                          sampleOff(0.3), silent};
  const ExtentErrors errors = measureExtentErrors(samples);
  EXPECT_EQ(errors.nearEstimateProportion.count, 2);
  EXPECT_EQ(errors.nearEstimateProportion.total, 5) << "what is not declared is not near";
  EXPECT_NEAR(errors.relativeCentroidError, (0.25 + 0.3) / 2.0, 1e-12) << "0.2, 0.25, 0.3 and 1.5";
  EXPECT_TRUE(std::isnan(errors.relativeSizeError)) << "nobody estimates it";
}

TEST(ExtentErrors, CountSizesTooLargeAndTooSmallAlike) {
  std::vector<ExtentSample> samples(4, sampleOff(0.01));
  samples[0].estimatedRadius = 0.08;  // 20 %
  samples[1].estimatedRadius = 0.13;  // 30 %
  samples[2].estimatedRadius = 0.101; // 1 %
  EXPECT_NEAR(measureExtentErrors(samples).relativeSizeError, 0.2, 1e-12) << "the fourth has none";
}

TEST(ExtentErrors, NothingUsableIsLeftOut) {
  EXPECT_TRUE(std::isnan(measureExtentErrors({}).nearEstimateProportion.value()));
  EXPECT_TRUE(std::isnan(measureExtentErrors({}).relativeCentroidError));
  std::vector<ExtentSample> samples{sampleOff(std::numeric_limits<double>::quiet_NaN()),
                                    {0.0, 0.0, 0.0, 0.1}};
  const ExtentErrors errors = measureExtentErrors(samples);
  EXPECT_EQ(errors.nearEstimateProportion.count, 0);
  EXPECT_EQ(errors.nearEstimateProportion.total, 2);
  EXPECT_TRUE(std::isnan(errors.relativeCentroidError));
  EXPECT_TRUE(std::isnan(errors.relativeSizeError));
}

} // namespace
} // namespace dewpoint::tests
