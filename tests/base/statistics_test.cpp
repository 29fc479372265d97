// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/statistics.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace dewpoint::tests {
namespace {

TEST(UpperMedian, IsTheUpperOfTwoInTheMiddle) {
  EXPECT_EQ(upperMedian({5.0, 1.0, 3.0}), 3.0);
  EXPECT_EQ(upperMedian({5.0, 1.0, 3.0, 4.0}), 4.0);
  EXPECT_EQ(upperMedian({2.0}), 2.0);
  EXPECT_EQ(upperMedian({}), 0.0);
  std::vector<double> values{5.0, 1.0, 3.0, 4.0};
  EXPECT_EQ(upperMedianInPlace(values), 4.0);
}

TEST(Median, IsTheMeanOfTwoInTheMiddle) {
  EXPECT_EQ(median({5.0, 1.0, 3.0}), 3.0);
  EXPECT_EQ(median({5.0, 1.0, 3.0, 4.0}), 3.5);
  EXPECT_EQ(median({}), 0.0);
}

// Tables of Student's t, two-sided: 3.182, 2.571, 2.262, and 1.960 of the normal distribution.
TEST(StudentQuantile, IsThatOfTheTables) {
  EXPECT_NEAR(studentQuantile95(3.0), 3.182, 0.04);
  EXPECT_NEAR(studentQuantile95(5.0), 2.571, 0.01);
  EXPECT_NEAR(studentQuantile95(9.0), 2.262, 0.001);
  EXPECT_NEAR(studentQuantile95(std::numeric_limits<double>::infinity()), 1.960, 0.001);
}

// Four values are at 0, 1/3, 2/3 and 1: a half is in the middle between the inner ones.
TEST(Quantile, IsLinearBetweenOrderStatistics) {
  const std::vector<double> sorted{1.0, 3.0, 4.0, 8.0};
  EXPECT_EQ(quantile(sorted, 0.0), 1.0);
  EXPECT_EQ(quantile(sorted, 1.0), 8.0);
  EXPECT_DOUBLE_EQ(quantile(sorted, 0.5), 3.5);
  EXPECT_DOUBLE_EQ(quantile(sorted, 1.0 / 6.0), 2.0);
  EXPECT_EQ(quantile({7.0}, 0.3), 7.0);
}

} // namespace
} // namespace dewpoint::tests
