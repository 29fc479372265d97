// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_palette.h"
#include "core/geometry/image_box.h"

#include <vector>

namespace dewpoint::observation {

/// Computes the color contrast between a box and its surroundings, for many boxes in one image. The
/// contrast compares the color histograms of the box and of a ring around it, as in Liu et al.
/// (Learning to detect a salient object, CVPR 2007).
class BoxContrast {
public:
  /// Prepares an image (CV_8UC3). The object whose box is sought must be visible at `pixel`.
  BoxContrast(const cv::Mat& bgr, const Eigen::Vector2d& pixel);

  /// Returns the contrast of a box, at most 1. Let f(c) be the smoothed fraction of color c in the
  /// oval that touches the sides of the box, and b(c) the fraction of c in a ring that surrounds
  /// this oval and is 1.6 times as large. The contrast is a product of two means of (f - b) / (f +
  /// b): the mean over the pixels in the oval, and the mean at the pixel passed to the constructor.
  /// The contrast is 0 if the color at that pixel is more typical of the ring, or if no part of the
  /// ring is in the image.
  double contrastOf(const ImageBox& box) const;

private:
  using Shares = ColorPalette::Shares;
  struct Colors {
    Shares counts{};
    double pixelCount = 0.0;
  };
  /// Adds the colors of the pixels in a rectangle, which is rounded to whole pixels, to `colors`.
  void add(double left, double top, double right, double bottom, Colors& colors) const;
  Colors colorsInOval(const ImageBox& box) const;
  const int* integralAt(int x, int y) const {
    return &sums_[(static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width + 1) +
                   static_cast<std::size_t>(x)) *
                  ColorPalette::kColorCount];
  }

  cv::Size size_;
  ColorPalette palette_;
  std::vector<int> sums_; ///< integral images: (rows + 1) x (columns + 1) x colors
  Colors known_;          ///< colors at the pixel passed to the constructor
};

} // namespace dewpoint::observation
