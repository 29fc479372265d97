// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/instruction_set.h"
#include "core/base/random.h"
#include "core/color/color_classifier.h"
#include "core/color/hsi.h"
#include "core/color/match_image.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace dewpoint::tests {
namespace {

constexpr std::size_t kColors = std::size_t{1} << 24U;

/// Narrow, wide, wrapping, half a circle, one hue, every hue; saturation bounds on both sides of
/// 1/4, where the line changes its axes; bounds that many colors lie on exactly.
const std::vector<ColorRange> kRanges{
    {330.0, 20.0, 0.2, 1.0, 0.1, 0.9},    {0.0, 60.0, 0.0, 1.0, 0.0, 1.0},
    {60.0, 240.0, 0.1, 0.8, 0.05, 0.95},  {100.0, 99.0, 0.0, 1.0, 0.0, 1.0},
    {10.5, 290.25, 0.0, 0.5, 0.3, 0.6},   {300.0, 180.0, 0.25, 1.0, 0.0, 1.0},
    {120.0, 120.0, 0.0, 1.0, 0.0, 1.0},   {0.0, 360.0, 0.0, 0.1, 0.8, 1.0},
    {359.0, 1.0, 0.25, 0.75, 0.25, 0.75}, {200.0, 200.5, 1.0, 1.0, 0.0, 1.0},
};

/// Every color there is, as an image of 4096 x 4096.
cv::Mat everyColor() {
  cv::Mat image(4096, 4096, CV_8UC3);
  std::uint8_t* byte = image.ptr<std::uint8_t>();
  for (std::size_t color = 0; color < kColors; ++color) {
    *byte++ = static_cast<std::uint8_t>(color);
    *byte++ = static_cast<std::uint8_t>(color >> 8U);
    *byte++ = static_cast<std::uint8_t>(color >> 16U);
  }
  return image;
}

TEST(ColorClassifier, IsTheReferenceForEveryColor) {
  const cv::Mat image = everyColor();
  std::vector<ColorClassifier> classifiers(kRanges.begin(), kRanges.end());
  std::vector<cv::Mat> matchImages;
  for (const ColorClassifier& classifier : classifiers) {
    matchImages.push_back(matchImage(image, classifier));
    for (const InstructionSet limit : {InstructionSet::Baseline, InstructionSet::Avx2}) {
      const InstructionSetLimit limited(limit);
      EXPECT_EQ(cv::norm(matchImages.back(), matchImage(image, classifier), cv::NORM_INF), 0.0);
    }
  }
  std::vector<int> differing(kRanges.size(), 0);
  std::vector<int> matching(kRanges.size(), 0);
  for (std::size_t color = 0; color < kColors; ++color) {
    const std::uint8_t* pixel = image.ptr<std::uint8_t>() + 3 * color;
    const Hsi hsi = hsiFromBgr(pixel[0], pixel[1], pixel[2]);
    for (std::size_t i = 0; i < kRanges.size(); ++i) {
      const bool reference = matches(hsi, kRanges[i]);
      const bool alone = classifiers[i].matches(pixel[0], pixel[1], pixel[2]);
      const bool inImage = matchImages[i].ptr<std::uint8_t>()[color] != 0;
      matching[i] += reference ? 1 : 0;
      differing[i] += alone != reference || inImage != reference ? 1 : 0;
    }
  }
  for (std::size_t i = 0; i < kRanges.size(); ++i) {
    EXPECT_EQ(differing[i], 0) << "range " << i;
    EXPECT_GT(matching[i], 0) << "range " << i; // or the comparison would say nothing
  }
}

// Lines are made for any bound: a thousand ranges at random, on colors at random.
TEST(ColorClassifier, IsTheReferenceForRangesAtRandom) {
  const RandomStream stream(20, 0, 0, RandomPurpose::Noise);
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const auto hue = stream.uniform3(i, 1);
    const auto saturation = stream.uniform3(i, 2);
    const ColorRange range{
        360.0 * hue[0], 360.0 * hue[1], saturation[0] * saturation[1], saturation[0], 0.0, 1.0};
    const ColorClassifier classifier(range);
    for (std::uint32_t j = 0; j < 1000; ++j) {
      const auto word = stream.randomWords(j, 3);
      const auto b = static_cast<std::uint8_t>(word[0]);
      const auto g = static_cast<std::uint8_t>(word[1]);
      const auto r = static_cast<std::uint8_t>(word[2]);
      ASSERT_EQ(classifier.matches(b, g, r), matches(hsiFromBgr(b, g, r), range))
          << "range " << i << ": " << int(b) << ' ' << int(g) << ' ' << int(r);
    }
  }
}

// Rows of every length up to two blocks' worth of leftovers, nothing written beyond the end.
TEST(MatchRow, IsTheSameForEveryInstructionSetAndLength) {
  const cv::Mat image = everyColor();
  const std::uint8_t* pixels = image.ptr<std::uint8_t>(2113);
  for (const ColorRange& range : kRanges) {
    const ColorClassifier classifier(range);
    for (const InstructionSet limit :
         {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512}) {
      const InstructionSetLimit limited(limit);
      for (const int count : {0, 1, 2, 15, 16, 31, 33, 63, 64, 65, 100, 511, 512, 513, 1100}) {
        std::vector<std::uint8_t> out(static_cast<std::size_t>(count) + 1, 7);
        classifier.matchRow(pixels, count, out.data());
        ASSERT_EQ(out.back(), 7);
        for (int i = 0; i < count; ++i) {
          const bool alone =
              classifier.matches(pixels[3 * i], pixels[3 * i + 1], pixels[3 * i + 2]);
          ASSERT_EQ(out[static_cast<std::size_t>(i)], alone ? 255 : 0) << i << " of " << count;
        }
      }
    }
  }
}

} // namespace
} // namespace dewpoint::tests
