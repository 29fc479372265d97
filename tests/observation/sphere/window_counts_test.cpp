// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/instruction_set.h"
#include "core/base/random.h"
#include "core/color/hsi.h"
#include "core/observation/sphere/window_counts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace dewpoint::tests {
namespace {

const ColorRange kReds{330.0, 40.0, 0.3, 1.0, 0.1, 0.9};

cv::Mat noise(int rows, int columns) {
  const RandomStream stream(6, 0, 0, RandomPurpose::Noise);
  cv::Mat image(rows, columns, CV_8UC3);
  for (int pixel = 0; pixel < rows * columns; ++pixel) {
    const auto word = stream.randomWords(static_cast<std::uint32_t>(pixel));
    image.at<cv::Vec3b>(pixel / columns, pixel % columns) =
        cv::Vec3b(word[0] & 0xffU, word[1] & 0xffU, word[2] & 0xffU);
  }
  return image;
}

/// Pixel by pixel, by the arc cosine.
int reference(const cv::Mat& image, int column, int row) {
  int count = 0;
  for (int y = std::max(row - 2, 0); y <= std::min(row + 2, image.rows - 1); ++y) {
    for (int x = std::max(column - 2, 0); x <= std::min(column + 2, image.cols - 1); ++x) {
      const auto& bgr = image.at<cv::Vec3b>(y, x);
      count += matches(hsiFromBgr(bgr[0], bgr[1], bgr[2]), kReds) ? 1 : 0;
    }
  }
  return count;
}

// From a single pixel to more than a vector, whole images and parts of larger ones.
TEST(WindowCounts, AreThoseOfEveryPixelsWindow) {
  const ColorClassifier classifier(kReds);
  const cv::Mat large = noise(40, 200);
  for (const InstructionSet limit :
       {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512}) {
    const InstructionSetLimit limited(limit);
    WindowCounts counts;
    for (const cv::Size size :
         {cv::Size(1, 1), cv::Size(3, 2), cv::Size(5, 5), cv::Size(67, 9), cv::Size(200, 40)}) {
      const cv::Mat image = large(cv::Rect(cv::Point(0, 0), size));
      counts.build(image, classifier);
      std::vector<std::int32_t> pixels;
      for (int i = 0; i <= size.area(); ++i) { // the last one is outside
        pixels.push_back(i);
      }
      for (std::size_t begin = 0; begin < pixels.size(); begin += kMaxWindows) {
        const int length =
            static_cast<int>(std::min<std::size_t>(kMaxWindows, pixels.size() - begin));
        std::array<std::uint8_t, kMaxWindows> sparse{};
        countWindows(image, classifier, length, pixels.data() + begin, sparse.data());
        for (int i = 0; i < length; ++i) {
          const int pixel = pixels[begin + std::size_t(i)];
          const int column = pixel % size.width;
          const int row = pixel / size.width;
          const int expected = row < size.height ? reference(image, column, row) : 0;
          ASSERT_EQ(counts.data()[pixel], expected) << column << ' ' << row;
          ASSERT_EQ(sparse[std::size_t(i)], expected) << column << ' ' << row;
          if (row < size.height) {
            ASSERT_EQ(countWindow(image, classifier, column, row), expected);
          }
        }
      }
    }
  }
}

} // namespace
} // namespace dewpoint::tests
