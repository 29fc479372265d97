// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/boxes/fine_histogram.h"

#include <array>
#include <cstdint>
#include <vector>

namespace dewpoint::observation {

/// One value per color bin: max(0, 2 P - 1) in units of 1 / TargetColors::kFixedPointOne, where P
/// is the probability that a pixel of this color belongs to the target. The value is 0 if the color
/// is at least as frequent in the surroundings as on the target.
using BinShares = std::vector<std::uint16_t>;

/// Color histograms of a target and of its surroundings. The target's box is divided into parts,
/// each with its own histogram. All histograms adapt to slow changes. The histograms of the target
/// adapt only halfway, because the first image always keeps half of the weight.
class TargetColors {
public:
  static constexpr int kColumnCount = 2;
  static constexpr int kRowCount = 3;
  static constexpr int kPartCount = kColumnCount * kRowCount;
  static constexpr std::uint16_t kFixedPointOne = 256;

  /// Discards everything and learns the colors of a box, whose center must be in the image.
  void learn(const cv::Mat& bgr, const ImageBox& box);
  /// Adapts the histograms of the target to the image inside a box: moves them by the fraction
  /// `rate`, 0 to 1, toward the histograms of the box. Pixels whose colors are more typical of the
  /// surroundings count less, so that surroundings inside the box are not learned.
  void adaptTarget(const cv::Mat& bgr, const ImageBox& box, double rate);
  /// Adapts the histogram of the surroundings to an image: moves it by the fraction `rate`, 0 to 1,
  /// toward the result of surroundingsHistogramOf().
  void adaptSurroundings(const cv::Mat& bgr, const ImageBox& box, double rate);

  /// Returns max(0, 2 P(target | color) - 1) per color bin for a part. Parts are numbered row by
  /// row from the upper left. P is q² / (q² + b²), where q is the histogram of the part and b is
  /// the histogram of the surroundings.
  BinShares binShares(int part) const;

  /// Returns the similarity between a box and the target as first learned, in [0, 1]: the mean of
  /// max(0, 2 P - 1) over the pixels of the box. P is computed with the current surroundings.
  double similarityOf(const cv::Mat& bgr, const ImageBox& box) const;

  /// Returns the approximate size of a copy, bytes.
  std::size_t memoryBytes() const {
    // All histograms have the same size.
    return sizeof(double) * surroundings_.capacity() * (2 * kPartCount + 1);
  }

  /// Returns part number `part` of a box. Parts are numbered row by row from the upper left.
  static ImageBox partOf(const ImageBox& box, int part);

private:
  FineHistogram figureOf(FineHistogram now, const FineHistogram& reference) const;

  std::array<FineHistogram, kPartCount> first_;
  std::array<FineHistogram, kPartCount> parts_;
  FineHistogram surroundings_;
};

} // namespace dewpoint::observation
