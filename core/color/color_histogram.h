// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace dewpoint::color {

/// Histograms of hue (whole degrees), saturation and intensity (hundredths) as fractions of the
/// pixels. The color picker displays these histograms behind its handles. Gray pixels have no hue,
/// so the hue fractions add up to the fraction of colored pixels.
struct ColorHistogram {
  std::array<double, 360> hue{};
  std::array<double, 101> saturation{};
  std::array<double, 101> intensity{};
};

/// Returns the histogram of all images combined (CV_8UC3; images of other types are ignored).
ColorHistogram histogramOf(const std::vector<cv::Mat>& images);

} // namespace dewpoint::color
