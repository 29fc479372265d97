// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/sensor/shutter.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dewpoint::tests {
namespace {

using namespace dewpoint::simulation;

TEST(Shutter, RowsAreTakenOneAfterTheOther) {
  const Shutter shutter{0.01, 0.02};
  EXPECT_NEAR(rowTime(shutter, 0, 241), -0.01, 1e-12);
  EXPECT_NEAR(rowTime(shutter, 120, 241), 0.0, 1e-12);
  EXPECT_NEAR(rowTime(shutter, 240, 241), 0.01, 1e-12);
  EXPECT_EQ(rowTime({0.01, 0.0}, 5, 241), 0.0) << "a global shutter";
}

TEST(Shutter, BandsCoverAllRowsAtTheirMiddleTimes) {
  const Shutter shutter{0.01, 0.02};
  const auto bands = rowBands(shutter, 243);
  ASSERT_EQ(bands.size(), 16U) << "15 of 16 rows and one of 3";
  int next = 0;
  for (const RowBand& band : bands) {
    EXPECT_EQ(band.firstRow, next);
    next = band.endRow;
    double sum = 0.0;
    for (int row = band.firstRow; row < band.endRow; ++row) {
      sum += rowTime(shutter, row, 243);
    }
    EXPECT_NEAR(band.centerTime, sum / (band.endRow - band.firstRow), 1e-12);
  }
  EXPECT_EQ(next, 243);
  EXPECT_EQ(rowBands({0.01, 0.0}, 243).size(), 1U);
}

TEST(Flicker, MakesBandsWithThePeriodOfTheLight) {
  // 20 ms of readout over 200 steps: 10 ms, a period of 100 Hz, are 100 rows.
  const Flicker flicker{100.0, 0.2, 0.7};
  const auto gains = rowGains(flicker, {0.0, 0.02}, 201, 1.0);
  EXPECT_NEAR(gains[0], gains[100], 1e-5);
  EXPECT_NEAR(gains[13], gains[113], 1e-5);
  EXPECT_NEAR(gains[0] + gains[50], 2.0, 1e-5) << "half a period later";
  EXPECT_NEAR(*std::ranges::max_element(gains), 1.2, 1e-3);
}

TEST(Flicker, AnExposureOfWholePeriodsSeesNone) {
  for (const double seconds : {0.01, 0.02}) {
    for (const float gain : rowGains({100.0, 0.3, 0.2}, {seconds, 0.02}, 50, 0.3)) {
      EXPECT_NEAR(gain, 1.0, 1e-6);
    }
  }
  // Half a period keeps sin(pi / 2) / (pi / 2) = 0.637 of the swing.
  const auto gains = rowGains({100.0, 0.3, 0.0}, {0.005, 0.02}, 2001, 0.0);
  EXPECT_NEAR(*std::ranges::max_element(gains), 1.0 + 0.3 * 0.6366, 1e-3);
}

} // namespace
} // namespace dewpoint::tests
