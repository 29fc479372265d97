// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/boxes/box_kernel.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace dewpoint::observation {
namespace {

constexpr double kSum = 2147483648.0; // 2^31: half the range of an accumulator
constexpr double kFinest = 16777216.0;
constexpr double kFar = 1e8; // pixels; keeps positions within int

int wholePixels(double length) {
  return std::max(1, static_cast<int>(std::lround(length)));
}

} // namespace

BoxKernel::BoxKernel(const ImageBox& box)
    : BoxKernel(wholePixels(box.width), wholePixels(box.height)) {}

BoxKernel::BoxKernel(int width, int height) : width_(width), height_(height) {
  assert(width > 0 && height > 0);
  const double reachSquared = 0.25 * (double(width) * width + double(height) * height);
  std::vector<double> exact;
  double sum = 0.0;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const double x = column + 0.5 - 0.5 * width;
      const double y = row + 0.5 - 0.5 * height;
      exact.push_back(kernelProfile((x * x + y * y) / reachSquared));
      sum += exact.back();
    }
  }
  const double scale = std::min(kFinest, (kSum - double(exact.size())) / sum);
  weights_.reserve(exact.size());
  for (const double weight : exact) {
    weights_.push_back(static_cast<std::uint32_t>(std::lround(weight * scale)));
    sum_ += weights_.back();
  }
}

KernelPlacement placeKernel(const BoxKernel& kernel, double x, double y, int columns, int rows) {
  KernelPlacement placement;
  const auto whole = [](double value) {
    return static_cast<int>(std::floor(std::clamp(value, -kFar, kFar) + 0.5));
  };
  placement.imageLeft = whole(x - 0.5 * kernel.width());
  placement.imageTop = whole(y - 0.5 * kernel.height());
  placement.firstColumn = std::max(0, -placement.imageLeft);
  placement.endColumn = std::min(kernel.width(), columns - placement.imageLeft);
  placement.firstRow = std::max(0, -placement.imageTop);
  placement.endRow = std::min(kernel.height(), rows - placement.imageTop);
  return placement;
}

} // namespace dewpoint::observation
