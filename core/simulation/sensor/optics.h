// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <opencv2/core.hpp>

namespace dewpoint::simulation {

/// The image (CV_32F) as a lens that is not quite sharp gives it: its point spread function is a
/// Gaussian of `sigmaPx` pixels, the same all over. The border repeats its last pixels; 0 pixels
/// leave the image as it is.
cv::Mat blurred(const cv::Mat& image, double sigmaPx);

} // namespace dewpoint::simulation
