// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/image_box.h"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace dewpoint::observation {

/// Computes the weighted color histogram of a box in an image (CV_8UC3), by equations 7 and 8 of
/// Sugandi et al. 2009. It has 8 x 8 x 8 RGB bins, numbered as by rgbBin(). The box is rounded to
/// whole pixels, as in the method `sugandi`. Only pixels of the box that lie inside the image are
/// counted, and the histogram sums to 1. It is empty if there are no such pixels.
std::vector<double> boxHistogram(const cv::Mat& bgr, const ImageBox& box);

} // namespace dewpoint::observation
