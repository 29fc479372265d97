// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_palette.h"
#include "core/geometry/image_box.h"

#include <vector>

namespace dewpoint::observation {

/// How much what fills a box differs in color from what is around it, for many boxes of one
/// picture: center against surround, by color histograms (as Liu et al., Learning to detect a
/// salient object, CVPR 2007, compare a rectangle with its ring).
class FigureContrast {
public:
  /// Of a picture, CV_8UC3, and the pixel of it that is known to be of the figure.
  FigureContrast(const cv::Mat& bgr, const Eigen::Vector2d& pixel);

  /// At most 1. With f(c) and b(c) the softened shares of a color in the oval that touches the
  /// box's sides and in the ring around it that is 1.6 times as large, it is the mean of
  /// (f - b) / (f + b) over the pixels in the oval, times the mean at the known pixel. 0 where the
  /// pixel has rather a color of the ring, or where there is no ring in the picture.
  double at(const ImageBox& box) const;

private:
  using Shares = ColorPalette::Shares;
  struct Colors {
    Shares counts{};
    double pixels = 0.0;
  };
  /// Those in a rectangle that is rounded to pixels.
  void add(double left, double top, double right, double bottom, Colors& colors) const;
  Colors inOval(const ImageBox& box) const;
  const int* upTo(int x, int y) const {
    return &sums_[(static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width + 1) +
                   static_cast<std::size_t>(x)) *
                  ColorPalette::kColors];
  }

  cv::Size size_;
  ColorPalette palette_;
  std::vector<int> sums_; ///< integral images: (rows + 1) x (columns + 1) x colors
  Colors known_;          ///< at the pixel
};

} // namespace dewpoint::observation
