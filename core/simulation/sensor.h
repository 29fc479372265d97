// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"

#include <opencv2/core.hpp>

namespace dewpoint::simulation {

/// What the sensor makes of the light: CV_8UC3 from a CV_32FC3 image (BGR, [0, 255]), with normal
/// noise of `noiseSigma` gray levels drawn from `stream`.
cv::Mat develop(const cv::Mat& image, double noiseSigma, const RandomStream& stream);

/// The image (CV_8UC3) as it comes back from a JPEG file of `quality` 1 to 100.
cv::Mat throughJpeg(const cv::Mat& image, int quality);

/// Gains over the image (CV_32FC3): light that falls off towards the corners by `vignette` and
/// changes linearly by `right` and `down` from the middle to the borders.
cv::Mat unevenLight(cv::Size size, double vignette, double right, double down);

} // namespace dewpoint::simulation
