// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_sample.h"
#include "core/color/hsi.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <vector>

namespace dewpoint::color {

/// Colors that are about the same, and how much of them there is.
struct HsiColors {
  Hsi color;
  double weight = 0.0;
};

/// Counts colors, those together that differ by less than sensor noise; each cell stands for its
/// mean color.
class HsiCounts {
public:
  HsiCounts();
  /// Counts the pixels of `image` (CV_8UC3; another type is left out) where `skip` (CV_8UC1 of the
  /// same size, or empty) is 0; each as much as `weight`, which is negative to take back what was
  /// counted.
  void add(const cv::Mat& image, const cv::Mat& skip, double weight = 1.0);
  void add(const BgrColor& color, double weight);
  double total() const { return total_; }
  std::vector<HsiColors> colors() const;

private:
  static constexpr int kBits = 6; ///< per channel: 4 gray levels
  struct Cell {
    std::array<double, 3> sum{};
    double weight = 0.0;
  };
  std::vector<Cell> cells_;
  double total_ = 0.0;
};

} // namespace dewpoint::color
