// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_sample.h"
#include "core/color/hsi.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <vector>

namespace dewpoint::color {

/// Mean color of a group of similar colors, and the total weight of the group.
struct WeightedHsiColor {
  Hsi color;
  double weight = 0.0;
};

/// Counts how often colors occur. Colors that differ by less than sensor noise share a cell. A cell
/// is represented by the mean of its colors.
class HsiCounts {
public:
  HsiCounts();
  /// Counts the pixels in `image` (CV_8UC3; images of other types are ignored) where `skip`
  /// (CV_8UC1 of the same size) is 0, or all pixels if `skip` is empty. Each pixel adds `weight`. A
  /// negative weight removes pixels that were counted earlier.
  void add(const cv::Mat& image, const cv::Mat& skip, double weight = 1.0);
  void add(const BgrColor& color, double weight);
  double totalWeight() const { return total_; }
  std::vector<WeightedHsiColor> colors() const;

private:
  static constexpr int kBits = 6; ///< bits per channel: a cell spans 4 gray levels
  struct Cell {
    std::array<double, 3> colorSum{};
    double weight = 0.0;
  };
  std::vector<Cell> cells_;
  double total_ = 0.0;
};

} // namespace dewpoint::color
