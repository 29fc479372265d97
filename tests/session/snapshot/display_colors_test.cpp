// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/snapshot/display_colors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace dewpoint::tests {
namespace {

const std::vector<DisplayColor>& palette() {
  return displayPalette(DisplayBackground::Light);
}

ColorRange rangeAbout(double hue, double saturation = 0.5, double intensity = 0.5) {
  return {normalizedHue(hue - 12.0), normalizedHue(hue + 12.0), saturation - 0.1,
          saturation + 0.1,          intensity - 0.1,           intensity + 0.1};
}

/// Relative luminance, of linear light; 0 to 1.
double luminance(const DisplayColor& color) {
  const auto linear = [](double v) {
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color[0]) + 0.7152 * linear(color[1]) + 0.0722 * linear(color[2]);
}

TEST(DisplayColors, APinkBallIsPink) {
  // The range of the simulated ball.
  const ColorRange pink{320.0, 352.0, 0.25, 0.65, 0.15, 0.90};
  const auto colors = displayColors({{.learnedColors = pink}}, DisplayBackground::Light);
  ASSERT_EQ(colors.size(), 1U);
  EXPECT_GT(colors[0][0], colors[0][2] + 0.1); // red above blue above green
  EXPECT_GT(colors[0][2], colors[0][1] + 0.1);
  EXPECT_FALSE(areSimilar(colors[0], palette()[0]));
}

TEST(DisplayColors, TheMiddleOfTheHuesMayLieAcrossZero) {
  const auto red = centralColor(rangeAbout(2.0));
  ASSERT_TRUE(red.has_value());
  EXPECT_GT(red->x(), 0.8);
  EXPECT_LT(red->y(), 0.4);
  EXPECT_LT(red->z(), 0.4);
}

TEST(DisplayColors, GrayAndManyHuesAreNoColor) {
  EXPECT_FALSE(centralColor(ColorRange{}).has_value());
  EXPECT_FALSE(centralColor({0.0, 360.0, 0.2, 1.0, 0.0, 1.0}).has_value());
  EXPECT_FALSE(centralColor({100.0, 120.0, 0.0, 0.6, 0.2, 0.8}).has_value());
  const auto colors = displayColors({{}, {.learnedColors = ColorRange{}}}, DisplayBackground::Dark);
  EXPECT_EQ(colors[0], palette()[0]);
  EXPECT_EQ(colors[1], palette()[1]);
}

TEST(DisplayColors, EachReadsOnItsGround) {
  for (double hue = 0.0; hue < 360.0; hue += 20.0) {
    for (const double intensity : {0.12, 0.5, 0.88}) {
      const auto middle = centralColor(rangeAbout(hue, 0.5, intensity));
      ASSERT_TRUE(middle.has_value()) << hue;
      const DisplayColor onLight = legibleColor(*middle, DisplayBackground::Light);
      const DisplayColor onDark = legibleColor(*middle, DisplayBackground::Dark);
      EXPECT_LT(luminance(onLight), 0.45) << hue; // the floor is white
      EXPECT_GT(luminance(onDark), 0.18) << hue;  // the floor has 0.02
      const DisplayColor onImage = legibleColor(*middle, DisplayBackground::Image);
      EXPECT_GT(luminance(onImage), 0.35) << hue; // a line with a dark halo
      for (const DisplayColor& color : {onLight, onDark, onImage}) {
        EXPECT_GE(color.minCoeff(), 0.0);
        EXPECT_LE(color.maxCoeff(), 1.0);
      }
    }
  }
  const DisplayColor fine(0.8, 0.3, 0.5);
  EXPECT_EQ(legibleColor(fine, DisplayBackground::Light), fine);
}

TEST(DisplayColors, TargetsThatLookAlikeHaveColorsOfThePalette) {
  const auto colors = displayColors({{.learnedColors = rangeAbout(330.0)},
                                     {.learnedColors = rangeAbout(120.0)},
                                     {.learnedColors = rangeAbout(334.0)}},
                                    DisplayBackground::Light);
  EXPECT_EQ(colors[0], palette()[0]);
  EXPECT_GT(colors[1][1], colors[1][0]); // stays green
  EXPECT_FALSE(areSimilar(colors[0], colors[2]));
  EXPECT_FALSE(areSimilar(colors[1], colors[2])); // not the green of the palette
}

TEST(DisplayColors, PeopleKeepTheirs) {
  const DisplayColor identity(0.1, 0.2, 0.9);
  const auto colors =
      displayColors({{.fixedColor = identity}, {.fixedColor = identity}}, DisplayBackground::Dark);
  EXPECT_EQ(colors[0], identity);
  EXPECT_EQ(colors[1], identity);
}

TEST(DisplayColors, ATargetHasOneHueOnEveryGround) {
  // Two blues that differ in lightness, and two targets without a color.
  const std::vector<DisplayColorSource> sources{{.learnedColors = rangeAbout(220.0, 0.5, 0.2)},
                                                {.learnedColors = rangeAbout(220.0, 0.5, 0.8)},
                                                {.learnedColors = rangeAbout(120.0)},
                                                {},
                                                {}};
  const auto image = displayColors(sources, DisplayBackground::Image);
  for (const DisplayBackground ground : {DisplayBackground::Light, DisplayBackground::Dark}) {
    const auto colors = displayColors(sources, ground);
    for (std::size_t k = 0; k < sources.size(); ++k) {
      const auto inPalette = [k](const std::vector<DisplayColor>& shown, DisplayBackground where) {
        return std::ranges::find(displayPalette(where), shown[k]) - displayPalette(where).begin();
      };
      EXPECT_EQ(inPalette(image, DisplayBackground::Image), inPalette(colors, ground)) << k;
    }
    EXPECT_GT(colors[2][1], colors[2][0]); // green
  }
}

TEST(DisplayColors, WhatIsDrawnOverTheTargetIsLighterThanTheTarget) {
  const auto pink = centralColor({320.0, 352.0, 0.25, 0.65, 0.15, 0.90});
  ASSERT_TRUE(pink.has_value());
  EXPECT_GT(luminance(legibleColor(*pink, DisplayBackground::Image)), 1.5 * luminance(*pink));
}

TEST(DisplayColors, MoreTargetsThanThePaletteHasStillHaveOneEach) {
  const auto colors = displayColors(std::vector<DisplayColorSource>(palette().size() + 2),
                                    DisplayBackground::Light);
  ASSERT_EQ(colors.size(), palette().size() + 2);
  EXPECT_EQ(colors.back(), palette()[1]);
}

TEST(DisplayColors, OfManyTargetsTheFirstOnesKeepTheirColors) {
  std::vector<DisplayColorSource> sources(kMaxOwnColors + 2);
  sources.front().learnedColors = rangeAbout(120.0);
  sources.back().learnedColors = rangeAbout(120.0); // too many to compare
  const auto colors = displayColors(sources, DisplayBackground::Light);
  EXPECT_EQ(colors.front(),
            legibleColor(*centralColor(rangeAbout(120.0)), DisplayBackground::Light));
  EXPECT_EQ(colors.back(), palette()[(kMaxOwnColors + 1) % palette().size()]);
}

} // namespace
} // namespace dewpoint::tests
