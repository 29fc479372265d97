// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>

namespace dewpoint::color {

/// Number of bins in the color histogram of Sugandi et al. 2009, section 2.2: RGB with 8 x 8 x 8
/// bins.
inline constexpr int kRgbBinCount = 512;

/// Returns the bin of a color, 0 to kRgbBinCount - 1: h(x) in equation 7 of Sugandi et al. 2009.
inline std::uint16_t rgbBin(std::uint8_t blue, std::uint8_t green, std::uint8_t red) {
  return static_cast<std::uint16_t>(((red >> 5) << 6) | ((green >> 5) << 3) | (blue >> 5));
}

/// Number of bins per channel for smoothed histograms, which use the finer division 16 x 16 x 16.
inline constexpr int kFineRgbBinsPerChannel = 16;
inline constexpr int kFineRgbBinCount = 4096;

/// Returns the fine bin of a color, 0 to kFineRgbBinCount - 1.
inline std::uint16_t fineRgbBin(std::uint8_t blue, std::uint8_t green, std::uint8_t red) {
  return static_cast<std::uint16_t>(((red >> 4) << 8) | ((green >> 4) << 4) | (blue >> 4));
}

/// Writes the bins of the pixels in the rectangle `part` of an image (CV_8UC3) to the same
/// rectangle of `bins`. If needed, `bins` is reallocated as CV_16UC1 with the size of the image.
/// Pixels outside `part` are unchanged.
void findRgbBins(const cv::Mat& bgr, const cv::Rect& part, cv::Mat& bins);

} // namespace dewpoint::color
