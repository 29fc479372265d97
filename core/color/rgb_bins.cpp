// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/rgb_bins.h"

#include "core/base/vector_kernel.h"

#include <cstddef>

namespace dewpoint::color {
namespace {

struct BinKernel {
  DEWPOINT_KERNEL void run(const std::uint8_t* bgr, int count, std::uint16_t* bins) {
    for (std::ptrdiff_t i = 0; i < count; ++i) {
      bins[i] = rgbBin(bgr[3 * i], bgr[3 * i + 1], bgr[3 * i + 2]);
    }
  }
};

} // namespace

void findRgbBins(const cv::Mat& bgr, const cv::Rect& part, cv::Mat& bins) {
  bins.create(bgr.size(), CV_16UC1);
  for (int row = part.y; row < part.y + part.height; ++row) {
    runKernel<BinKernel>(bgr.ptr<std::uint8_t>(row) + 3 * std::ptrdiff_t(part.x), part.width,
                         bins.ptr<std::uint16_t>(row) + part.x);
  }
}

} // namespace dewpoint::color
