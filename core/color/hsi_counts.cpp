// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/hsi_counts.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace dewpoint::color {

HsiCounts::HsiCounts() : cells_(std::size_t{1} << (3 * kBits)) {}

void HsiCounts::add(const BgrColor& color, double weight) {
  constexpr int kShift = 8 - kBits;
  std::size_t index = 0;
  for (const std::uint8_t channel : color) {
    index = index << kBits | channel >> kShift;
  }
  Cell& cell = cells_[index];
  for (std::size_t i = 0; i < 3; ++i) {
    cell.colorSum[i] += weight * color[i];
  }
  cell.weight += weight;
  total_ += weight;
}

void HsiCounts::add(const cv::Mat& image, const cv::Mat& skip, double weight) {
  if (image.type() != CV_8UC3) {
    return;
  }
  for (int y = 0; y < image.rows; ++y) {
    const std::uint8_t* pixel = image.ptr<std::uint8_t>(y);
    const std::uint8_t* skipped = skip.empty() ? nullptr : skip.ptr<std::uint8_t>(y);
    for (int x = 0; x < image.cols; ++x, pixel += 3) {
      if (skipped == nullptr || skipped[x] == 0) {
        add(BgrColor{pixel[0], pixel[1], pixel[2]}, weight);
      }
    }
  }
}

std::vector<WeightedHsiColor> HsiCounts::colors() const {
  std::vector<WeightedHsiColor> colors;
  for (const Cell& cell : cells_) {
    if (cell.weight > 0.0) {
      std::array<std::uint8_t, 3> mean{};
      for (std::size_t i = 0; i < 3; ++i) {
        mean[i] = static_cast<std::uint8_t>(std::lround(cell.colorSum[i] / cell.weight));
      }
      colors.push_back({hsiFromBgr(mean[0], mean[1], mean[2]), cell.weight});
    }
  }
  return colors;
}

} // namespace dewpoint::color
