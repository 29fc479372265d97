// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_tickers.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

std::vector<double> ticksOf(QCPAxisTicker& ticker, double lower, double upper) {
  QVector<double> ticks;
  QVector<QString> labels;
  ticker.generate(QCPRange(lower, upper), QLocale::c(), u'g', 5, ticks, nullptr, &labels);
  std::vector<double> shown;
  for (qsizetype k = 0; k < ticks.size(); ++k) {
    EXPECT_NEAR(labels[k].toDouble(), ticks[k], 1e-9 * (1.0 + std::abs(ticks[k])));
    if (ticks[k] >= lower && ticks[k] <= upper) {
      shown.push_back(ticks[k]);
    }
  }
  return shown;
}

TEST(PlotTickers, LowPlotsHaveTwoNumbersAtLeastAndAtMost) {
  ValueTicker ticker;
  for (const double lower : {-8.0, 0.0, 0.08, 0.498, 3.3, 120.0}) {
    for (const double size : {0.0012, 0.05, 0.52, 1.1, 7.0, 216.0, 4100.0}) {
      const auto ticks = ticksOf(ticker, lower, lower + size);
      EXPECT_EQ(ticks.size(), 2U) << lower << " and " << size << " more";
    }
  }
  // By hand: 0.08 to 0.62 holds 0.2, 0.4 and 0.6; every second of them is two.
  const auto ticks = ticksOf(ticker, 0.08, 0.62);
  ASSERT_EQ(ticks.size(), 2U);
  EXPECT_NEAR(ticks[0], 0.2, 1e-12);
  EXPECT_NEAR(ticks[1], 0.6, 1e-12);
}

TEST(PlotTickers, HighPlotsHaveMore) {
  ValueTicker ticker;
  ticker.setMaxTicks(6);
  EXPECT_EQ(ticksOf(ticker, -0.05, 1.05).size(), 6U); // 0, 0.2 … 1
}

TEST(PlotTickers, DecadesAreTheLowestAndTheHighest) {
  DecadeTicker ticker;
  EXPECT_EQ(ticksOf(ticker, 0.6, 15.0), (std::vector{1.0, 10.0}));
  EXPECT_EQ(ticksOf(ticker, 0.06, 1500.0).size(), 2U);
  ticker.setMaxTicks(5);
  EXPECT_EQ(ticksOf(ticker, 0.06, 1500.0).size(), 5U); // 0.1 to 1000
}

} // namespace
} // namespace dewpoint::tests
