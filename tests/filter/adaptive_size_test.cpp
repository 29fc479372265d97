// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/adaptive_size.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dewpoint::tests {
namespace {

// Fox 2003: n = chi²(k - 1; 0.99) / (2 error). The quantiles are those of printed
// tables of the chi-square distribution; the Wilson-Hilferty approximation is within 1 % of them.
TEST(KldSampleSize, IsTheChiSquareQuantileOverTwiceTheError) {
  struct Row {
    std::int64_t bins;
    double quantile;
  };
  for (const Row& row : {Row{2, 6.635}, Row{3, 9.210}, Row{6, 15.086}, Row{11, 23.209},
                         Row{21, 37.566}, Row{31, 50.892}, Row{51, 76.154}, Row{101, 135.807}}) {
    for (const double error : {0.01, 0.05, 0.2}) {
      const double exact = row.quantile / (2.0 * error);
      EXPECT_NEAR(double(kldSampleSize(row.bins, error)), exact, 0.01 * exact + 1.0)
          << row.bins << " bins, error " << error;
    }
  }
}

TEST(KldSampleSize, GrowsWithBinsAndFallsWithTheError) {
  for (std::int64_t bins = 2; bins < 500; ++bins) {
    EXPECT_GE(kldSampleSize(bins + 1, 0.05), kldSampleSize(bins, 0.05));
    EXPECT_GE(kldSampleSize(bins, 0.05), kldSampleSize(bins, 0.06));
  }
}

TEST(KldSampleSize, IsAtLeastOne) {
  EXPECT_EQ(kldSampleSize(0, 0.05), 1);
  EXPECT_EQ(kldSampleSize(1, 0.05), 1);
  EXPECT_GE(kldSampleSize(2, 1e9), 1);
  EXPECT_GE(kldSampleSize(100, 0.0), 1);
  EXPECT_GE(kldSampleSize(100, std::numeric_limits<double>::quiet_NaN()), 1);
}

TEST(OccupiedBins, CountsCubesOnce) {
  Eigen::ArrayXXd states(5, 3);
  states << 0.01, 0.01, 0.01, //
      0.09, 0.05, 0.02,       // the same cube of edge 0.1
      0.11, 0.01, 0.01,       // the next in x
      0.01, 0.01, -0.01,      // below zero is another cube, not the same rounded towards zero
      0.01, 0.31, 0.01;       // another in y
  EXPECT_EQ(countOccupiedBins(states, 0.1), 4);
  EXPECT_EQ(countOccupiedBins(states, 1.0), 2);  // all but the one below zero
  EXPECT_EQ(countOccupiedBins(states, 1e-4), 5); // each its own
  EXPECT_EQ(countOccupiedBins(states.topRows(1), 0.1), 1);
  EXPECT_EQ(countOccupiedBins(states.topRows(0), 0.1), 0);
}

TEST(OccupiedBins, LooksAtThePlaceOnly) {
  Eigen::ArrayXXd states = Eigen::ArrayXXd::Zero(10, 6);
  states.col(4) = Eigen::ArrayXd::LinSpaced(10, -5.0, 5.0);
  EXPECT_EQ(countOccupiedBins(states, 0.01), 1);
}

TEST(OccupiedBins, SurvivesPlacesFarAway) {
  Eigen::ArrayXXd states = Eigen::ArrayXXd::Zero(3, 3);
  states(1, 0) = 1e300;
  states(2, 0) = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(countOccupiedBins(states, 0.01), 3);
}

} // namespace
} // namespace dewpoint::tests
