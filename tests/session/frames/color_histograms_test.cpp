// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/rgb_bins.h"
#include "core/session/frames/color_histograms.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dewpoint::tests {
namespace {

TEST(ColorHistograms, TheLargestBinsAreShownInTheirOrder) {
  ColorHistograms histograms{std::vector<double>(512, 0.0), std::vector<double>(512, 0.0)};
  const std::size_t red = rgbBin(0, 0, 255);   // blue, green, red: bin 7 * 64
  const std::size_t green = rgbBin(0, 255, 0); // bin 7 * 8
  const std::size_t gray = rgbBin(100, 100, 100);
  histograms.reference[red] = 0.5;
  histograms.reference[green] = 0.5;
  histograms.candidate[red] = 0.32;
  histograms.candidate[green] = 0.08;
  histograms.candidate[gray] = 0.6;
  const std::vector<ColorBar> bars = largestBars(histograms, 10);
  ASSERT_EQ(bars.size(), 3U);
  EXPECT_EQ(bars[0].rgb, (std::array<std::uint8_t, 3>{16, 240, 16}));
  EXPECT_EQ(bars[2].rgb, (std::array<std::uint8_t, 3>{240, 16, 16}));
  EXPECT_EQ(bars[2].referenceShare, 0.5);
  EXPECT_EQ(bars[2].candidateShare, 0.32);
  EXPECT_EQ(largestBars(histograms, 1)[0].candidateShare, 0.6);
  // sqrt(0.5 * 0.32) + sqrt(0.5 * 0.08) = 0.4 + 0.2
  EXPECT_NEAR(histograms.similarity(), 0.6, 1e-12);
}

} // namespace
} // namespace dewpoint::tests
