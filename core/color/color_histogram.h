// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace dewpoint::color {

/// Histogram of hue (whole degrees), saturation and intensity (hundredths) as shares of the pixels.
/// A color picker shows it behind its handles. Gray pixels have no hue: the shares of all hues add
/// up to the share of the colored pixels.
struct ColorHistogram {
  std::array<double, 360> hue{};
  std::array<double, 101> saturation{};
  std::array<double, 101> intensity{};
};

/// Histogram of all images together (CV_8UC3; images of other types are ignored).
ColorHistogram histogramOf(const std::vector<cv::Mat>& images);

} // namespace dewpoint::color
