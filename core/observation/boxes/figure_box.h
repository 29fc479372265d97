// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/image_box.h"

#include <opencv2/core/mat.hpp>

namespace dewpoint::observation {

/// The part of a drawn box that is more figure than ground: boxes are drawn with a margin, and what
/// is in the margin is not the target. Figure colors f come from the center of the box: its
/// center-weighted histogram n is taken as half figure, half ground b (the box's surroundings), so
/// that f = max(0, n - b / 2), normalized. With P = f / (f + b) for the color of a pixel, the
/// result is the box of whole pixels within the drawn one, of at least half its width and height,
/// with the greatest sum of P - 1/2 (the maximum subwindow). Where colors do not tell figure from
/// ground (no box has a positive sum) it is the drawn box. `drawn` must have its center in the
/// image (CV_8UC3).
ImageBox figureBox(const cv::Mat& bgr, const ImageBox& drawn);

} // namespace dewpoint::observation
