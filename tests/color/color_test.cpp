// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/color_classifier.h"
#include "core/color/color_range.h"
#include "core/color/hsi.h"
#include "core/color/match_image.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <cmath>
#include <limits>
#include <string>

namespace dewpoint::tests {
namespace {

bool both(const ColorRange& range, int b, int g, int r) {
  const bool reference = matches(hsiFromBgr(b, g, r), range);
  EXPECT_EQ(ColorClassifier(range).matches(b, g, r), reference) << b << ' ' << g << ' ' << r;
  return reference;
}

void expectHsi(int b, int g, int r, double hue, double saturation, double intensity) {
  const Hsi color = hsiFromBgr(b, g, r);
  EXPECT_NEAR(color.hueDegrees, hue, 1e-9) << b << ' ' << g << ' ' << r;
  EXPECT_NEAR(color.saturation, saturation, 1e-12) << b << ' ' << g << ' ' << r;
  EXPECT_NEAR(color.intensity, intensity, 1e-12) << b << ' ' << g << ' ' << r;
}

TEST(Hsi, PrimariesAndTheirMixtures) {
  expectHsi(0, 0, 255, 0.0, 1.0, 1.0 / 3);     // red
  expectHsi(0, 255, 255, 60.0, 1.0, 2.0 / 3);  // yellow
  expectHsi(0, 255, 0, 120.0, 1.0, 1.0 / 3);   // green
  expectHsi(255, 255, 0, 180.0, 1.0, 2.0 / 3); // cyan
  expectHsi(255, 0, 0, 240.0, 1.0, 1.0 / 3);   // blue
  expectHsi(255, 0, 255, 300.0, 1.0, 2.0 / 3); // magenta
}

TEST(Hsi, HandComputedColors) {
  // R 200, G 100, B 150: cos = 0.5 (100 + 50) / sqrt(100^2 + 50 * -50) = 75 / 86.60254 = cos 30,
  // B > G, so 330; S = 1 - 300 / 450; I = 450 / 765.
  expectHsi(150, 100, 200, 330.0, 1.0 / 3, 450.0 / 765);
  // R 100, G 200, B 150: cos = 0.5 (-100 - 50) / 86.60254 = cos 150, B < G; S and I as above.
  expectHsi(150, 200, 100, 150.0, 1.0 / 3, 450.0 / 765);
  // R 10, G 20, B 60: cos = 0.5 (-10 - 50) / sqrt(100 + 50 * 40) = -30 / 45.8257569 =
  // -0.6546537, acos = 130.8933946, B > G, so 229.1066054; S = 1 - 30 / 90; I = 90 / 765.
  expectHsi(60, 20, 10, 229.10660535086909, 2.0 / 3, 90.0 / 765);
}

TEST(Hsi, GrayHasNoHue) {
  for (const int level : {0, 1, 128, 255}) {
    const Hsi gray = hsiFromBgr(level, level, level);
    EXPECT_TRUE(std::isnan(gray.hueDegrees));
    EXPECT_NEAR(gray.saturation, 0.0, 1e-15);
    EXPECT_NEAR(gray.intensity, level / 255.0, 1e-15);
    EXPECT_FALSE(both({0.0, 359.0}, level, level, level));
    EXPECT_FALSE(both({200.0, 100.0}, level, level, level));
  }
}

// Grays, primaries and what lies between. The arc cosine is worth 8 digits near its ends.
TEST(Hsi, TheInverseGivesTheColorBack) {
  for (int b = 0; b < 256; b += 15) {
    for (int g = 0; g < 256; g += 15) {
      for (int r = 0; r < 256; r += 15) {
        const auto bgr = bgrFromHsi(hsiFromBgr(b, g, r));
        ASSERT_NEAR(bgr[0], b, 1e-4) << b << ' ' << g << ' ' << r;
        ASSERT_NEAR(bgr[1], g, 1e-4) << b << ' ' << g << ' ' << r;
        ASSERT_NEAR(bgr[2], r, 1e-4) << b << ' ' << g << ' ' << r;
      }
    }
  }
}

TEST(ColorRange, HueWrapsThroughZero) {
  const ColorRange reds{330.0, 30.0};
  EXPECT_TRUE(both(reds, 0, 0, 255));     // 0
  EXPECT_TRUE(both(reds, 150, 100, 200)); // 330, a bound
  EXPECT_TRUE(both(reds, 100, 150, 200)); // 30, the other
  EXPECT_FALSE(both(reds, 0, 255, 255));  // 60
  EXPECT_FALSE(both(reds, 255, 0, 255));  // 300
  EXPECT_FALSE(both(reds, 255, 255, 0));  // 180, opposite
  const ColorRange others{30.0, 330.0};   // the other way around, bounds included
  EXPECT_FALSE(both(others, 0, 0, 255));
  EXPECT_TRUE(both(others, 150, 100, 200));
  EXPECT_TRUE(both(others, 100, 150, 200));
  EXPECT_TRUE(both(others, 255, 255, 0));
}

TEST(ColorRange, ASingleHueIsNotItsOpposite) {
  EXPECT_TRUE(both({120.0, 120.0}, 0, 255, 0));
  EXPECT_FALSE(both({120.0, 120.0}, 255, 0, 255));
  EXPECT_TRUE(both({0.0, 0.0}, 0, 0, 255));
  EXPECT_TRUE(both({360.0, 0.0}, 0, 0, 255));
  EXPECT_FALSE(both({0.0, 0.0}, 255, 255, 0));
}

TEST(ColorRange, HalfCircleHasBothEnds) {
  EXPECT_TRUE(both({60.0, 240.0}, 0, 255, 255));
  EXPECT_TRUE(both({60.0, 240.0}, 255, 0, 0));
  EXPECT_TRUE(both({60.0, 240.0}, 0, 255, 0));
  EXPECT_FALSE(both({60.0, 240.0}, 0, 0, 255));
}

TEST(ColorRange, EveryHueLetsGrayThroughButNeverBlack) {
  const ColorRange everything{0.0, 360.0};
  EXPECT_TRUE(both(everything, 90, 90, 90));
  EXPECT_TRUE(both(everything, 255, 255, 255));
  EXPECT_TRUE(both(everything, 1, 2, 3));
  EXPECT_FALSE(both(everything, 0, 0, 0));
}

TEST(ColorRange, IntensityGateIsInclusive) {
  // Reds of intensity R / 765.
  const ColorRange range{350.0, 10.0, 0.0, 1.0, 100.0 / 765, 200.0 / 765};
  EXPECT_FALSE(both(range, 0, 0, 99));
  EXPECT_TRUE(both(range, 0, 0, 100));
  EXPECT_TRUE(both(range, 0, 0, 200));
  EXPECT_FALSE(both(range, 0, 0, 201));
}

TEST(ColorRange, SaturationGateIsInclusive) {
  // G = B = 50: S = 1 - 150 / (R + 100), so R 100 gives 0.25 and R 200 gives 0.5.
  const ColorRange range{350.0, 10.0, 0.25, 0.5};
  EXPECT_FALSE(both(range, 50, 50, 99));
  EXPECT_TRUE(both(range, 50, 50, 100));
  EXPECT_TRUE(both(range, 50, 50, 200));
  EXPECT_FALSE(both(range, 50, 50, 201));
}

/// True if a component lies so near a bound that rounding may decide.
bool onABound(const Hsi& color, const ColorRange& range) {
  const auto near = [](double value, double bound) { return std::abs(value - bound) < 1e-9; };
  const auto nearHue = [&](double bound) {
    return near(std::abs(std::remainder(color.hueDegrees - bound, 360.0)), 0.0);
  };
  return nearHue(range.hueMin) || nearHue(range.hueMax) ||
         near(color.saturation, range.saturationMin) ||
         near(color.saturation, range.saturationMax) || near(color.intensity, range.intensityMin) ||
         near(color.intensity, range.intensityMax);
}

class Dense : public testing::TestWithParam<ColorRange> {};

TEST_P(Dense, ClassifierIsTheReference) {
  const ColorRange range = GetParam();
  const ColorClassifier classifier(range);
  int differing = 0;
  int matching = 0;
  for (int r = 0; r < 256; r += 3) { // 86 levels from 0 to 255
    for (int g = 0; g < 256; g += 3) {
      for (int b = 0; b < 256; b += 3) {
        const Hsi color = hsiFromBgr(b, g, r);
        const bool reference = matches(color, range);
        matching += reference ? 1 : 0;
        if (classifier.matches(b, g, r) != reference && !onABound(color, range)) {
          ++differing;
        }
      }
    }
  }
  EXPECT_EQ(differing, 0);
  EXPECT_GT(matching, 0); // or the comparison would say nothing
}

INSTANTIATE_TEST_SUITE_P(Ranges, Dense,
                         testing::Values(ColorRange{330.0, 20.0, 0.2, 1.0, 0.1, 0.9}, // pink
                                         ColorRange{0.0, 60.0, 0.0, 1.0, 0.0, 1.0},
                                         ColorRange{60.0, 240.0, 0.1, 0.8, 0.05, 0.95},
                                         ColorRange{100.0, 99.0, 0.0, 1.0, 0.0, 1.0},
                                         ColorRange{10.5, 290.25, 0.0, 0.5, 0.3, 0.6},
                                         ColorRange{300.0, 180.0, 0.0, 1.0, 0.0, 1.0},
                                         ColorRange{120.0, 120.0, 0.0, 1.0, 0.0, 1.0},
                                         ColorRange{0.0, 360.0, 0.0, 0.1, 0.8, 1.0},
                                         ColorRange{359.0, 1.0, 0.25, 0.75, 0.25, 0.75}));

TEST(MatchImage, MarksThePixelsThatMatch) {
  cv::Mat bgr(2, 3, CV_8UC3, cv::Scalar(0, 255, 0));
  bgr.at<cv::Vec3b>(1, 2) = {0, 0, 255};
  const cv::Mat match = matchImage(bgr, ColorClassifier(ColorRange{350.0, 10.0}));
  ASSERT_EQ(match.type(), CV_8UC1);
  ASSERT_EQ(match.size(), bgr.size());
  EXPECT_EQ(cv::countNonZero(match), 1);
  EXPECT_EQ(match.at<uchar>(1, 2), 255);
}

TEST(MatchImage, WorksOnAPartOfAnImage) {
  cv::Mat bgr(10, 10, CV_8UC3, cv::Scalar(0, 0, 255));
  bgr(cv::Rect(0, 0, 10, 5)).setTo(cv::Scalar(255, 0, 0));
  EXPECT_EQ(cv::countNonZero(
                matchImage(bgr(cv::Rect(2, 4, 3, 3)), ColorClassifier(ColorRange{350.0, 10.0}))),
            6); // one row of blue, two of red
}

TEST(ColorClassifier, OfSeveralRangesMatchesWhatLiesInAny) {
  const ColorRange reds{350.0, 10.0, 0.3};
  const ColorRange blues{220.0, 260.0, 0.2, 0.8};
  const ColorRange greens{100.0, 140.0, 0.5, 1.0, 0.1, 0.6};
  const ColorRanges all(reds, {blues, greens});
  const ColorClassifier classifier(all);
  cv::Mat pixels(3, 1500, CV_8UC3); // more than a block of columns
  cv::RNG random(5);
  random.fill(pixels, cv::RNG::UNIFORM, 0, 256);
  const cv::Mat match = matchImage(pixels, classifier);
  int matched = 0;
  for (int y = 0; y < pixels.rows; ++y) {
    for (int x = 0; x < pixels.cols; ++x) {
      const auto& pixel = pixels.at<cv::Vec3b>(y, x);
      const bool wanted = matches(hsiFromBgr(pixel[0], pixel[1], pixel[2]), all);
      ASSERT_EQ(match.at<std::uint8_t>(y, x), wanted ? 255 : 0) << x << ", " << y;
      ASSERT_EQ(classifier.matches(pixel[0], pixel[1], pixel[2]), wanted);
      matched += wanted ? 1 : 0;
    }
  }
  EXPECT_GT(matched, 300);
}

TEST(MatchImage, IsEmptyForWhatIsNotBgr) {
  const ColorClassifier reds(ColorRange{350.0, 10.0});
  EXPECT_TRUE(matchImage({}, reds).empty());
  EXPECT_TRUE(matchImage(cv::Mat(4, 4, CV_8UC1, cv::Scalar(9)), reds).empty());
}

void expectRefused(const ColorRange& range, const std::string& field) {
  const Status status = checkColorRange(range);
  ASSERT_FALSE(status.has_value()) << field;
  EXPECT_EQ(status.error().code, ErrorCode::BadValue);
  EXPECT_EQ(status.error().field, field);
}

TEST(CheckColorRange, TakesWhatMakesSense) {
  EXPECT_TRUE(checkColorRange({}).has_value());
  EXPECT_TRUE(checkColorRange({330.0, 20.0, 0.2, 0.2, 0.1, 1.0}).has_value());
  EXPECT_TRUE(checkColorRange({0.0, 360.0}).has_value());
}

TEST(CheckColorRange, RefusesTheRest) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  expectRefused({nan, 20.0}, "hue");
  expectRefused({0.0, infinity}, "hue");
  expectRefused({-1.0, 20.0}, "hue");
  expectRefused({0.0, 360.5}, "hue");
  expectRefused({0.0, 20.0, nan, 1.0}, "saturation");
  expectRefused({0.0, 20.0, 0.0, 1.1}, "saturation");
  expectRefused({0.0, 20.0, 0.6, 0.5}, "saturation");
  expectRefused({0.0, 20.0, 0.0, 1.0, -0.1, 1.0}, "intensity");
  expectRefused({0.0, 20.0, 0.0, 1.0, 0.0, nan}, "intensity");
  expectRefused({0.0, 20.0, 0.0, 1.0, 0.9, 0.2}, "intensity");
  expectRefused({0.0, 20.0, 0.0, 1.0, 0.0, 0.0}, "intensity"); // black only
}

} // namespace
} // namespace dewpoint::tests
