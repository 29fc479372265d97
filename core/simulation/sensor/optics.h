// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <opencv2/core.hpp>

namespace dewpoint::simulation {

/// Returns the image (CV_32F) as blurred by a lens. The point spread function is a Gaussian with a
/// standard deviation of `sigmaPx` pixels, the same everywhere. Outside the image, its border
/// pixels are repeated. If `sigmaPx` is 0, the image is unchanged.
cv::Mat blurred(const cv::Mat& image, double sigmaPx);

} // namespace dewpoint::simulation
