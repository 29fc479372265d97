// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <opencv2/core.hpp>

namespace dewpoint::simulation {

/// Returns the image (CV_32F) after blurring by a lens. The point spread function is a Gaussian
/// with a standard deviation of `sigmaPx` pixels, the same everywhere. Outside the image, the
/// border pixels are repeated. If `sigmaPx` is 0, the image is returned unchanged.
cv::Mat blurred(const cv::Mat& image, double sigmaPx);

} // namespace dewpoint::simulation
