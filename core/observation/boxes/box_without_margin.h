// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/image_box.h"

#include <opencv2/core/mat.hpp>

namespace dewpoint::observation {

/// Returns the part of a drawn box that shows more of the target (the figure) than of its
/// surroundings (the ground), because users draw boxes with a margin. Let n be the center-weighted
/// color histogram of the box, and b the histogram of the box's surroundings. n is assumed to be
/// half figure and half ground. The figure colors are therefore f = max(0, n - b / 2), normalized.
/// Let P = f / (f + b) for the color of a pixel. The candidates are all boxes of whole pixels
/// inside the drawn box with at least half its width and half its height. The result is the
/// candidate with the largest sum of P - 1/2 over its pixels. If no candidate has a positive sum,
/// colors do not separate figure from ground, and the result is the drawn box. `drawn` must have
/// its center in the image (CV_8UC3).
ImageBox boxWithoutMargin(const cv::Mat& bgr, const ImageBox& drawn);

} // namespace dewpoint::observation
