// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_classifier.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dewpoint::observation {

/// How many pixels match the target color in the 5x5 window around every pixel of an image, 0 to
/// 25; pixels outside the image do not match. Built once a frame, then one look-up per particle.
class WindowCounts {
public:
  static constexpr int kRadius = 2;
  static constexpr int kPixels = 25;

  /// Counts a whole image (CV_8UC3).
  void build(const cv::Mat& bgr, const ColorClassifier& classifier);
  void clear() { counts_.clear(); }
  bool empty() const { return counts_.empty(); }

  /// The counts row by row, with a zero behind the last one for whatever lies outside.
  const std::uint8_t* data() const { return counts_.data(); }

private:
  std::vector<std::uint8_t> counts_;
  std::vector<std::uint8_t> matches_; ///< the last five rows classified, one of zeros, and sums
};

/// Most windows that countWindows() takes at once.
inline constexpr int kMostWindows = 64;

/// The same counts for some windows only: their pixels are laid side by side and classified
/// together. counts[i] is for the window around the pixel at column pixels[i] % columns and row
/// pixels[i] / columns of `bgr` (CV_8UC3), and zero for pixels[i] = rows * columns, which stands
/// for outside.
void countWindows(const cv::Mat& bgr, const ColorClassifier& classifier, int windowCount,
                  const std::int32_t* pixels, std::uint8_t* counts);

/// Matching pixels in the 5x5 window around one pixel of `bgr` (CV_8UC3).
int countWindow(const cv::Mat& bgr, const ColorClassifier& classifier, int column, int row);

} // namespace dewpoint::observation
