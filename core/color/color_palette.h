// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <cstdint>

namespace dewpoint::color {

/// Dominant colors of an image, and their similarity to each other when shading is mostly ignored.
/// Colors are compared in CIE L*a*b* with half the weight for lightness. The similarity of two
/// colors is a Gaussian of their distance. The same image always produces the same palette.
class ColorPalette {
public:
  /// Number of colors in the palette.
  static constexpr std::size_t kColorCount = 24;
  using Shares = std::array<double, kColorCount>; ///< one value per color of the palette

  /// Computes the palette of an image (CV_8UC3, not empty) by k-means clustering. The first initial
  /// color is the color of the pixel `first` (clamped to the image). Each further initial color is
  /// the image color that is farthest from all earlier initial colors (Gonzalez 1985).
  ColorPalette(const cv::Mat& bgr, cv::Point first);

  /// Returns the index of the closest palette color for each pixel: CV_8UC1 with the size of the
  /// image.
  const cv::Mat& colorIndices() const { return labels_; }
  /// Returns a smoothed histogram. Each entry is the sum of all `counts`, where each count is
  /// weighted by the similarity of its color to the color of the entry.
  Shares spreadOverSimilarColors(const Shares& counts) const;

private:
  using Colors = std::array<cv::Vec3f, kColorCount>;
  static std::uint8_t nearest(const Colors& colors, const cv::Vec3f& color);
  static Colors farthestFirst(const cv::Mat& lab, cv::Point first);
  static void refineClusters(Colors& colors, const cv::Mat& lab);

  cv::Mat labels_;
  std::array<Shares, kColorCount> alike_{};
};

} // namespace dewpoint::color
