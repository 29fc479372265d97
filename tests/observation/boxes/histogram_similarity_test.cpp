// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/instruction_set.h"
#include "core/base/random.h"
#include "core/color/rgb_bins.h"
#include "core/observation/boxes/histogram_similarity.h"
#include "tests/observation/naive_histogram.h"

#include <gtest/gtest.h>

#include <numeric>

namespace dewpoint::tests {
namespace {

/// Colored blotches of a few pixels, with noise: histograms of many bins.
cv::Mat blotches(int columns, int rows, std::uint64_t seed) {
  const RandomStream stream(seed, 0, 0, RandomPurpose::Simulation);
  cv::Mat image(rows, columns, CV_8UC3);
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const auto blotch = stream.randomWords(std::uint32_t(1000 * (y / 7) + x / 9));
      const auto noise = stream.randomWords(std::uint32_t(1000000 + y * columns + x));
      for (int c = 0; c < 3; ++c) {
        image.at<cv::Vec3b>(y, x)[c] =
            std::uint8_t((blotch[std::size_t(c)] % 200) + noise[std::size_t(c)] % 50);
      }
    }
  }
  return image;
}

std::vector<double> referenceOf(const cv::Mat& bgr, const BoxKernel& kernel, double x, double y) {
  cv::Mat bins;
  findRgbBins(bgr, {{0, 0}, bgr.size()}, bins);
  return weightedHistogram(bins, kRgbBinCount, kernel, x, y);
}

TEST(RgbBins, AreEightPerChannel) {
  EXPECT_EQ(rgbBin(0, 0, 0), 0);
  EXPECT_EQ(rgbBin(31, 0, 0), 0);
  EXPECT_EQ(rgbBin(32, 0, 0), 1);
  EXPECT_EQ(rgbBin(0, 32, 0), 8);
  EXPECT_EQ(rgbBin(0, 0, 32), 64);
  EXPECT_EQ(rgbBin(255, 255, 255), kRgbBinCount - 1);
}

TEST(RgbBins, AreTheSameForEveryInstructionSet) {
  const cv::Mat image = blotches(101, 13, 3);
  for (const auto set : {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512}) {
    const InstructionSetLimit limit(set);
    cv::Mat bins;
    findRgbBins(image, {{0, 0}, image.size()}, bins);
    for (int y = 0; y < image.rows; ++y) {
      for (int x = 0; x < image.cols; ++x) {
        const auto& c = image.at<cv::Vec3b>(y, x);
        ASSERT_EQ(bins.at<std::uint16_t>(y, x), rgbBin(c[0], c[1], c[2]));
      }
    }
  }
}

TEST(BoxKernel, FollowsTheProfile) {
  const BoxKernel kernel(30, 30);
  // Equation 6 with a = half the diagonal, 15 sqrt(2): near the center r² = 2 (0.5)² / 450, at the
  // corner pixel r² = 2 (14.5)² / 450.
  const double center = 1.0 - 0.5 / 450.0;
  const double corner = 1.0 - 2.0 * 14.5 * 14.5 / 450.0;
  EXPECT_NEAR(double(kernel.row(0)[0]) / kernel.row(15)[15], corner / center, 1e-6);
  std::uint64_t sum = 0;
  for (int row = 0; row < 30; ++row) {
    sum = std::accumulate(kernel.row(row), kernel.row(row) + 30, sum);
  }
  EXPECT_LE(sum, std::uint64_t(1) << 31);
}

TEST(BoxKernel, HoldsTheSumOfALargeBox) {
  const BoxKernel kernel(1200, 900);
  std::uint64_t sum = 0;
  for (int row = 0; row < 900; ++row) {
    sum = std::accumulate(kernel.row(row), kernel.row(row) + 1200, sum);
  }
  EXPECT_LE(sum, std::uint64_t(1) << 31);
  EXPECT_GT(kernel.row(1)[1], 0U);
}

TEST(HistogramSimilarity, IsOneWhereTheReferenceIs) {
  const cv::Mat image = blotches(160, 120, 1);
  const BoxKernel kernel(31, 24);
  HistogramSimilarity similarity(referenceOf(image, kernel, 60.5, 50.0), kernel);
  similarity.loadColors(image, {{0, 0}, image.size()});
  EXPECT_NEAR(similarity.at(60.5, 50.0), 1.0, 1e-9); // equation 10 of equal histograms
}

TEST(HistogramSimilarity, IsZeroWithoutACommonColorAndOutside) {
  const cv::Mat image = blotches(160, 120, 1);
  std::vector<double> reference(kRgbBinCount, 0.0);
  reference[rgbBin(255, 255, 255)] = 1.0; // blotches() reaches 248: bin 7 of every channel is rare
  cv::Mat dark = image / 2;
  HistogramSimilarity similarity(reference, BoxKernel(30, 30));
  similarity.loadColors(dark, {{0, 0}, dark.size()});
  EXPECT_EQ(similarity.at(80.0, 60.0), 0.0);
  EXPECT_EQ(similarity.at(-15.0, 60.0), 0.0);
  EXPECT_EQ(similarity.at(1e300, 60.0), 0.0);
}

class HistogramSimilaritySizes : public testing::TestWithParam<cv::Size> {};

TEST_P(HistogramSimilaritySizes, EqualsTheEquationsWithin1e5) {
  const cv::Mat first = blotches(200, 150, 1);
  const cv::Mat image = blotches(200, 150, 2);
  const cv::Size size = GetParam();
  const BoxKernel kernel(size.width, size.height);
  const double x = 90.0 + 0.5 * size.width;
  const double y = 40.0 + 0.5 * size.height;
  const auto naive = naiveHistogram(first, {{90, 40}, size});
  HistogramSimilarity similarity(referenceOf(first, kernel, x, y), kernel);
  cv::Mat bins;
  findRgbBins(image, {{0, 0}, image.size()}, bins);
  for (const bool fromColors : {true, false}) {
    if (fromColors) {
      similarity.loadColors(image, {{0, 0}, image.size()});
    } else {
      similarity.loadBins(bins, {{0, 0}, image.size()});
    }
    for (int top = -size.height + 1; top < image.rows; top += 13) { // over every border too
      for (int left = -size.width + 1; left < image.cols; left += 11) {
        const double expected = naiveSimilarity(naiveHistogram(image, {{left, top}, size}), naive);
        const double center = left + 0.5 * size.width;
        ASSERT_NEAR(similarity.at(center + 0.3, top + 0.5 * size.height - 0.3), expected, 1e-5)
            << left << ", " << top; // the nearest whole pixel
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Boxes, HistogramSimilaritySizes,
                         testing::Values(cv::Size(30, 30), cv::Size(17, 50), cv::Size(1, 2),
                                         cv::Size(61, 33)));

} // namespace
} // namespace dewpoint::tests
