// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/image_box.h"

#include <opencv2/core/mat.hpp>

namespace dewpoint::observation {

/// Returns the part of a drawn box that shows more figure than ground. Users draw boxes with a
/// margin, which does not show the target. The center-weighted histogram n of the box is assumed to
/// be half figure and half ground b (the surroundings of the box). The figure colors are therefore
/// f = max(0, n - b / 2), normalized. Let P = f / (f + b) for the color of a pixel. The result is
/// the box of whole pixels inside the drawn box that has the largest sum of P - 1/2 (the maximum
/// subwindow). It has at least half the width and height of the drawn box. If colors do not
/// separate figure from ground (no box has a positive sum), the result is the drawn box. `drawn`
/// must have its center in the image (CV_8UC3).
ImageBox figureBox(const cv::Mat& bgr, const ImageBox& drawn);

} // namespace dewpoint::observation
