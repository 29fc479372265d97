// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"
#include "core/geometry/image_box.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dewpoint::observation {

/// Returns the kernel profile g(r) for the argument r²: 1 - r² for r < 1, otherwise 0 (Sugandi et
/// al. 2009, equation 6).
inline double kernelProfile(double rSquared) {
  return rSquared < 1.0 ? 1.0 - rSquared : 0.0;
}

/// Weights g(|y - x_j| / a) of the pixels x_j of a rectangle with center y, where g is
/// kernelProfile(). The weights are integers with a common scale, so their sums are exact and do
/// not depend on the order. `a` is half the diagonal of the rectangle, so every pixel has a
/// positive weight. Sugandi et al. 2009 call `a` the normalization factor without giving its value.
class BoxKernel {
public:
  /// Creates a kernel for a rectangle of this size in pixels, at least 1 x 1.
  BoxKernel(int width, int height);
  /// Creates the kernel for a box that is rounded to whole pixels.
  explicit BoxKernel(const ImageBox& box);

  int width() const { return width_; }
  int height() const { return height_; }
  /// Returns the sum of all weights.
  double sum() const { return sum_; }
  /// Returns the width() weights of one row.
  const std::uint32_t* row(int row) const {
    return weights_.data() + std::size_t(row) * std::size_t(width_);
  }

private:
  int width_;
  int height_;
  std::vector<std::uint32_t> weights_; ///< row by row; they sum to less than 2^31
  double sum_ = 0.0;
};

/// Position of a kernel over an image, and the part of the kernel that lies inside the image.
/// Pixels.
struct KernelPlacement {
  int imageLeft = 0;   ///< left edge of the whole kernel, in the image
  int imageTop = 0;    ///< top edge of the whole kernel, in the image
  int firstColumn = 0; ///< first kernel column that lies inside the image
  int endColumn = 0;   ///< one past the last kernel column inside the image
  int firstRow = 0;
  int endRow = 0;

  bool isEmpty() const { return endColumn <= firstColumn || endRow <= firstRow; }
};

/// Places a kernel on an image with `columns` x `rows` pixels. The center of the kernel is as near
/// to (x, y) as whole pixels allow, where (x, y) is in pixels from the upper left corner of the
/// image.
KernelPlacement placeKernel(const BoxKernel& kernel, double x, double y, int columns, int rows);

} // namespace dewpoint::observation
