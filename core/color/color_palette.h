// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <cstdint>

namespace dewpoint::color {

/// The few colors that a picture is made of, and how alike they are to one who does not mind some
/// shading. Colors lie in CIE L*a*b* with lightness counted half; alike is a Gauss function of
/// their distance there. The same picture gives the same palette.
class ColorPalette {
public:
  /// Colors of the palette.
  static constexpr std::size_t kColors = 24;
  using Shares = std::array<double, kColors>; ///< something per color

  /// Of a picture, CV_8UC3, not empty: begins with the color at `first` (clamped to the picture)
  /// and the one farthest from all before (Gonzalez 1985), then k-means.
  ColorPalette(const cv::Mat& bgr, cv::Point first);

  /// CV_8UC1 of the picture's size: which color is the nearest to that of each pixel.
  const cv::Mat& labels() const { return labels_; }
  /// Counts spread over the colors that are alike.
  Shares softened(const Shares& counts) const;

private:
  using Colors = std::array<cv::Vec3f, kColors>;
  static std::uint8_t nearest(const Colors& colors, const cv::Vec3f& color);
  static Colors farthestFirst(const cv::Mat& lab, cv::Point first);
  static void settle(Colors& colors, const cv::Mat& lab);

  cv::Mat labels_;
  std::array<Shares, kColors> alike_{};
};

} // namespace dewpoint::color
