// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/image_box.h"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace dewpoint::observation {

/// The weighted color histogram of a box in an image (CV_8UC3): equations 7 and 8 of Sugandi et al.
/// 2009, RGB with 8 x 8 x 8 bins, numbered as by rgbBin(). The box is laid on whole pixels, as the
/// method's own; the shares sum to 1 over its pixels within the image. Empty where there are none.
std::vector<double> boxHistogram(const cv::Mat& bgr, const ImageBox& box);

} // namespace dewpoint::observation
