// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dewpoint::observation {

/// g(r) = 1 - r² for r < 1, else 0 (Sugandi et al. 2009, equation 6).
inline double profile(double rSquared) {
  return rSquared < 1.0 ? 1.0 - rSquared : 0.0;
}

/// The weights g(|y - x_j| / a) of the pixels of a rectangle whose center is y, as whole numbers of
/// a common scale: their sums are exact and do not depend on the order. `a` is half the rectangle's
/// diagonal (the paper only calls it the normalization factor), so that no pixel weighs nothing.
class BoxKernel {
public:
  /// At least 1 x 1 pixels.
  BoxKernel(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  /// Of all weights.
  double sum() const { return sum_; }
  const std::uint32_t* row(int row) const {
    return weights_.data() + std::size_t(row) * std::size_t(width_);
  }

private:
  int width_;
  int height_;
  std::vector<std::uint32_t> weights_; ///< row by row; they sum to less than 2^31
  double sum_ = 0.0;
};

/// The part of a kernel, laid over an image, that lies within the image.
struct KernelPlacement {
  int left = 0; ///< of the whole kernel, in the image
  int top = 0;
  int firstColumn = 0; ///< of the kernel, within the image
  int endColumn = 0;
  int firstRow = 0;
  int endRow = 0;

  bool isEmpty() const { return endColumn <= firstColumn || endRow <= firstRow; }
};

/// The placement at which the kernel's center is nearest to (x, y), pixels from the image's corner:
/// whole pixels.
KernelPlacement placeKernel(const BoxKernel& kernel, double x, double y, int columns, int rows);

} // namespace dewpoint::observation
