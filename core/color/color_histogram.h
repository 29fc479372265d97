// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace dewpoint::color {

/// How often each hue (whole degrees), saturation and intensity (hundredths) occurs, as shares of
/// the pixels; what a color picker shows behind its handles. Gray pixels have no hue: the hues sum
/// to the share of the others.
struct ColorHistogram {
  std::array<double, 360> hue{};
  std::array<double, 101> saturation{};
  std::array<double, 101> intensity{};
};

/// Of all the images (CV_8UC3; others are left out) together.
ColorHistogram histogramOf(const std::vector<cv::Mat>& images);

} // namespace dewpoint::color
