// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/image_box.h"

#include <opencv2/core/mat.hpp>

namespace dewpoint::observation {

/// Returns the part of a drawn box that shows more of the target (the figure) than of its
/// surroundings (the ground). It is needed because users draw boxes with a margin, which does not
/// show the target. Let n be the center-weighted color histogram of the box, and b the histogram of
/// the box's surroundings. n is assumed to be half figure and half ground. The figure colors are
/// therefore f = max(0, n - b / 2), normalized. Let P = f / (f + b) for the color of a pixel. The
/// result is the box of whole pixels inside the drawn box with the largest sum of P - 1/2 over its
/// pixels (the maximum subwindow), among boxes with at least half the width and half the height of
/// the drawn box. If colors do not separate figure from ground (no box has a positive sum), the
/// result is the drawn box. `drawn` must have its center in the image (CV_8UC3).
ImageBox figureBox(const cv::Mat& bgr, const ImageBox& drawn);

} // namespace dewpoint::observation
