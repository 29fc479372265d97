// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/duration_histogram.h"

#include <gtest/gtest.h>

#include <limits>

namespace dewpoint::tests {
namespace {

TEST(DurationHistogram, IsZeroWhileEmpty) {
  const DurationHistogram histogram;
  EXPECT_EQ(histogram.count(), 0);
  EXPECT_EQ(histogram.quantile(0.5), 0.0);
  EXPECT_EQ(histogram.longest(), 0.0);
}

TEST(DurationHistogram, QuantilesAreWithinHalfAPercent) {
  DurationHistogram histogram;
  for (int k = 1; k <= 1000; ++k) {
    histogram.add(k * 1e-5); // 10 us to 10 ms: the share q does not exceed q * 10 ms
  }
  EXPECT_EQ(histogram.count(), 1000);
  for (const double share : {0.01, 0.1, 0.5, 0.9, 0.99, 0.999}) {
    EXPECT_NEAR(histogram.quantile(share), share * 0.01, 0.0051 * share * 0.01) << share;
  }
  EXPECT_EQ(histogram.longest(), 0.01);
  EXPECT_EQ(histogram.quantile(1.0), 0.01);
}

TEST(DurationHistogram, KeepsWhatLiesOutside) {
  DurationHistogram histogram;
  histogram.add(0.0);
  histogram.add(1e7);
  histogram.add(-1.0);
  histogram.add(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(histogram.count(), 2);
  EXPECT_LE(histogram.quantile(0.5), 1.01e-9);
  EXPECT_EQ(histogram.quantile(1.0), 1e7);
}

} // namespace
} // namespace dewpoint::tests
