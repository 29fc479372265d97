// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_classifier.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dewpoint::observation {

/// For every pixel of an image, the number of pixels (0 to 25) in the 5x5 window around it that
/// match the target color. Pixels outside the image do not match. The counts are computed once per
/// frame. Each particle then requires a single look-up.
class WindowCounts {
public:
  static constexpr int kRadius = 2;
  static constexpr int kWindowPixelCount = 25;

  /// Computes the counts of matching pixels for a whole image (CV_8UC3).
  void build(const cv::Mat& bgr, const ColorClassifier& classifier);
  void clear() { counts_.clear(); }
  bool empty() const { return counts_.empty(); }

  /// Returns the counts of all pixels, row by row, followed by a zero. The zero is used for
  /// positions outside the image.
  const std::uint8_t* data() const { return counts_.data(); }

private:
  std::vector<std::uint8_t> counts_;
  std::vector<std::uint8_t> matches_; ///< last five classified rows, a row of zeros, and sums
};

/// Maximum number of windows per call of countWindows().
inline constexpr int kMaxWindows = 64;

/// Counts the pixels that match the target color in `windowCount` windows of 5x5 pixels. counts[i]
/// is the count for the window around the pixel at column pixels[i] % columns and row pixels[i] /
/// columns of `bgr` (CV_8UC3). For pixels[i] = rows * columns, which means a position outside the
/// image, the count is zero. The pixels of the windows are placed side by side and classified
/// together.
void countWindows(const cv::Mat& bgr, const ColorClassifier& classifier, int windowCount,
                  const std::int32_t* pixels, std::uint8_t* counts);

/// Returns the number of pixels that match the target color in the 5x5 window around one pixel of
/// `bgr` (CV_8UC3).
int countWindow(const cv::Mat& bgr, const ColorClassifier& classifier, int column, int row);

} // namespace dewpoint::observation
