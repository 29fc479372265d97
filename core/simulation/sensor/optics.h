// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <opencv2/core.hpp>

namespace dewpoint::simulation {

/// Returns the image (CV_32F) of a slightly blurred lens: its point spread function is a Gaussian
/// of `sigmaPx` pixels, the same everywhere. The border repeats its last pixels; 0 pixels leave the
/// image unchanged.
cv::Mat blurred(const cv::Mat& image, double sigmaPx);

} // namespace dewpoint::simulation
