// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/image_box.h"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace dewpoint::observation {

/// Returns the weighted color histogram of a box in an image (CV_8UC3), by equations 7 and 8 of
/// Sugandi et al. 2009. The histogram has 8 x 8 x 8 RGB bins, numbered by rgbBin(), and sums to 1.
/// The box is rounded to whole pixels, as in the `sugandi` method. Only pixels inside the image are
/// counted; if the box has none, the result is empty.
std::vector<double> boxHistogram(const cv::Mat& bgr, const ImageBox& box);

} // namespace dewpoint::observation
