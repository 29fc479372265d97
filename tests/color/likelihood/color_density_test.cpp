// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/likelihood/color_density.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dewpoint::tests {
namespace {

double meanOf(const ColorDensity& density) {
  double sum = 0.0;
  for (std::size_t cell = 0; cell < kColorCellCount; ++cell) {
    sum += density.at(cell);
  }
  return sum / static_cast<double>(kColorCellCount);
}

const WeightedBgrColor kManyReds{{40.0, 40.0, 200.0}, 1.0};

TEST(ColorCells, EightLevelsOfEachChannelAreOne) {
  EXPECT_EQ(colorCell(0, 0, 0), 0);
  EXPECT_EQ(colorCell(7, 7, 7), 0);
  EXPECT_EQ(colorCell(0, 0, 8), 1);
  EXPECT_EQ(colorCell(0, 8, 0), 32);
  EXPECT_EQ(colorCell(8, 0, 0), 1024);
  EXPECT_EQ(colorCell(255, 255, 255), kColorCellCount - 1);
}

// Nothing is lost at the ends of the channels, be it by noise or where a sensor cuts off.
TEST(ColorDensity, TheMeanIsOne) {
  const std::vector<WeightedBgrColor> colors{
      kManyReds, {{0.0, 0.0, 0.0}, 3.0}, {{255.0, 255.0, 255.0}, 2.0}, {{10.0, 240.0, 255.0}, 0.5}};
  for (const double otherLight : {0.0, 0.05, 0.5, 1.0}) {
    EXPECT_NEAR(meanOf(ColorDensity(colors, otherLight)), 1.0, 1e-9) << otherLight;
  }
}

TEST(ColorDensity, NothingHasNone) {
  EXPECT_EQ(meanOf(ColorDensity({}, 0.5)), 0.0);
  EXPECT_EQ(meanOf(ColorDensity({{{40.0, 40.0, 200.0}, 0.0}}, 0.5)), 0.0);
}

// A color in the middle of its cell (levels 40 to 47 and 200 to 207), noise of 5 levels to both
// sides: the cell and its neighbors at one and two cells of 8 levels, by the normal density.
TEST(ColorDensity, NoiseSpreadsToAllSidesAlike) {
  const ColorDensity density({{{43.5, 43.5, 203.5}, 7.0}}, 0.0);
  const double one = std::exp(-0.5 * 1.6 * 1.6);
  const double two = std::exp(-0.5 * 3.2 * 3.2);
  const double sum = 1.0 + 2.0 * one + 2.0 * two;
  const double most = kColorCellCount / (sum * sum * sum);
  EXPECT_NEAR(density.at(colorCell(40, 40, 200)), most, 1e-6);
  EXPECT_NEAR(density.at(colorCell(48, 40, 200)), most * one, 1e-6);
  EXPECT_NEAR(density.at(colorCell(40, 32, 200)), most * one, 1e-6);
  EXPECT_NEAR(density.at(colorCell(40, 40, 216)), most * two, 1e-6);
  EXPECT_NEAR(density.at(colorCell(48, 32, 216)), most * one * one * two, 1e-6);
  EXPECT_EQ(density.at(colorCell(40, 40, 224)), 0.0);
}

TEST(ColorDensity, WeightsAreShares) {
  const WeightedBgrColor blue{{200.0, 60.0, 40.0}, 3.0};
  const ColorDensity both({kManyReds, blue}, 0.5);
  const ColorDensity red({kManyReds}, 0.5);
  const ColorDensity otherRed({{kManyReds.bgr, 100.0}}, 0.5);
  for (const std::size_t cell : {colorCell(40, 40, 200), colorCell(24, 24, 120)}) {
    EXPECT_GT(red.at(cell), 0.0);
    EXPECT_NEAR(both.at(cell), 0.25 * red.at(cell), 1e-9);
    EXPECT_NEAR(otherRed.at(cell), red.at(cell), 1e-9);
  }
}

// Half and one and a quarter of the light, paler, and 5 degrees of hue to both sides; but not 30
// degrees, nor gray, nor the complementary color.
TEST(ColorDensity, OtherLightMovesColorsAsShadingDoes) {
  const ColorDensity sharp({kManyReds}, 0.0);
  const ColorDensity wide({kManyReds}, 1.0);
  for (const std::size_t cell :
       {colorCell(20, 20, 100), colorCell(50, 50, 250), colorCell(56, 56, 168),
        colorCell(40, 56, 192), colorCell(56, 40, 192)}) {
    EXPECT_GT(wide.at(cell), sharp.at(cell) + 1.0) << cell;
  }
  for (const std::size_t cell : {colorCell(40, 96, 200), colorCell(96, 40, 200),
                                 colorCell(92, 92, 92), colorCell(200, 200, 40)}) {
    EXPECT_LT(wide.at(cell), 0.01) << cell;
  }
  EXPECT_LT(wide.at(colorCell(40, 40, 200)), sharp.at(colorCell(40, 40, 200)));
}

// Light does not make a gray colorful.
TEST(ColorDensity, GrayStaysGrayInOtherLight) {
  const ColorDensity wide({{{123.5, 123.5, 123.5}, 1.0}}, 1.0);
  EXPECT_GT(wide.at(colorCell(80, 80, 80)), 1.0);
  EXPECT_GT(wide.at(colorCell(170, 170, 170)), 1.0);
  EXPECT_LT(wide.at(colorCell(80, 80, 120)), 0.01);
}

} // namespace
} // namespace dewpoint::tests
