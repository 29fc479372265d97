// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/sphere/window_counts.h"

#include "core/base/vector_kernel.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

namespace dewpoint::observation {
namespace {

constexpr int kRadius = WindowCounts::kRadius;
constexpr int kWindow = 2 * kRadius + 1;

/// One row of counts from the five rows of matches (255 or 0, which is -1 or 0) around it.
/// `sums` has kRadius zeros before and behind its `count` elements.
struct CountRowKernel {
  DEWPOINT_KERNEL void run(const std::array<const std::uint8_t*, kWindow>* rows, int count,
                           std::uint8_t* __restrict sums, std::uint8_t* __restrict counts) {
    const auto [r0, r1, r2, r3, r4] = *rows;
    std::uint8_t* middle = sums + kRadius;
    for (int i = 0; i < count; ++i) {
      middle[i] = static_cast<std::uint8_t>(0 - r0[i] - r1[i] - r2[i] - r3[i] - r4[i]);
    }
    for (int i = 0; i < count; ++i) {
      counts[i] = static_cast<std::uint8_t>(sums[i] + sums[i + 1] + sums[i + 2] + sums[i + 3] +
                                            sums[i + 4]);
    }
  }
};

} // namespace

void WindowCounts::build(const cv::Mat& bgr, const ColorClassifier& classifier) {
  const auto columns = static_cast<std::size_t>(bgr.cols);
  counts_.resize(bgr.total() + 1);
  counts_.back() = 0;
  matches_.assign((kWindow + 2) * columns + std::size_t{2} * kRadius, 0);
  const auto matchesOf = [&](int row) {
    const bool inside = row >= 0 && row < bgr.rows;
    return matches_.data() + static_cast<std::size_t>(inside ? row % kWindow : kWindow) * columns;
  };
  std::uint8_t* sums = matches_.data() + (kWindow + 1) * columns;
  for (int next = 0; next < bgr.rows + kRadius; ++next) {
    if (next < bgr.rows) {
      classifier.matchRow(bgr.ptr<std::uint8_t>(next), bgr.cols, matchesOf(next));
    }
    const int row = next - kRadius;
    if (row >= 0) {
      const std::array<const std::uint8_t*, kWindow> around{matchesOf(row - 2), matchesOf(row - 1),
                                                            matchesOf(row), matchesOf(row + 1),
                                                            matchesOf(row + 2)};
      runKernel<CountRowKernel>(&around, bgr.cols, sums,
                                counts_.data() + static_cast<std::size_t>(row) * columns);
    }
  }
}

namespace {

/// Sums of 25 bytes each, 255 or 0, divided by 255.
struct SumWindowsKernel {
  DEWPOINT_KERNEL void run(const std::uint8_t* matches, int windowCount, std::uint8_t* sums) {
    for (int i = 0; i < windowCount; ++i) {
      const std::uint8_t* window = matches + std::ptrdiff_t{WindowCounts::kWindowPixelCount} * i;
      std::array<std::uint64_t, 3> words{};
      std::memcpy(words.data(), window, sizeof words);
      const int bits = __builtin_popcountll(words[0]) + __builtin_popcountll(words[1]) +
                       __builtin_popcountll(words[2]) + (window[24] & 8);
      sums[i] = static_cast<std::uint8_t>(bits / 8);
    }
  }
};

/// A window none of whose pixels is outside.
bool isWhole(const cv::Mat& bgr, int column, int row) {
  return column >= kRadius && row >= kRadius && column < bgr.cols - kRadius &&
         row < bgr.rows - kRadius;
}

} // namespace

void countWindows(const cv::Mat& bgr, const ColorClassifier& classifier, int windowCount,
                  const std::int32_t* pixels, std::uint8_t* counts) {
  constexpr int kRowBytes = 3 * kWindow;
  std::array<std::uint8_t, std::size_t{kMaxWindows} * kWindow * kRowBytes> windows;
  std::array<std::uint8_t, std::size_t{kMaxWindows} * WindowCounts::kWindowPixelCount> matches;
  std::array<int, kMaxWindows> whole;
  int wholeCount = 0;
  windows.front() = 0; // g++ 12 warns about the rest
  std::uint8_t* next = windows.data();
  for (int i = 0; i < windowCount; ++i) {
    const int row = pixels[i] / bgr.cols;
    const int column = pixels[i] % bgr.cols;
    if (!isWhole(bgr, column, row)) {
      counts[i] = row < bgr.rows
                      ? static_cast<std::uint8_t>(countWindow(bgr, classifier, column, row))
                      : std::uint8_t{0};
      continue;
    }
    const std::uint8_t* source =
        bgr.ptr<std::uint8_t>(row - kRadius) + std::ptrdiff_t{3} * (column - kRadius);
    for (int y = 0; y < kWindow; ++y, source += bgr.step[0], next += kRowBytes) {
      std::memcpy(next, source, kRowBytes);
    }
    whole[static_cast<std::size_t>(wholeCount++)] = i;
  }
  classifier.matchRow(windows.data(), std::int64_t{WindowCounts::kWindowPixelCount} * wholeCount,
                      matches.data());
  std::array<std::uint8_t, kMaxWindows> sums;
  runKernel<SumWindowsKernel>(matches.data(), wholeCount, sums.data());
  for (int i = 0; i < wholeCount; ++i) {
    counts[whole[static_cast<std::size_t>(i)]] = sums[static_cast<std::size_t>(i)];
  }
}

int countWindow(const cv::Mat& bgr, const ColorClassifier& classifier, int column, int row) {
  const int left = std::max(column - kRadius, 0);
  const int right = std::min(column + kRadius, bgr.cols - 1);
  int count = 0;
  for (int y = std::max(row - kRadius, 0); y <= std::min(row + kRadius, bgr.rows - 1); ++y) {
    const std::uint8_t* pixel = bgr.ptr<std::uint8_t>(y) + std::ptrdiff_t{3} * left;
    for (int x = left; x <= right; ++x, pixel += 3) {
      count += classifier.matches(pixel[0], pixel[1], pixel[2]) ? 1 : 0;
    }
  }
  return count;
}

} // namespace dewpoint::observation
