// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"

#include <opencv2/core.hpp>

namespace dewpoint::simulation {

/// Converts light to the image of a sensor: CV_8UC3 from a CV_32FC3 image (BGR, [0, 255]), with
/// normal noise of `noiseSigma` gray levels drawn from `stream`.
cv::Mat develop(const cv::Mat& image, double noiseSigma, const RandomStream& stream);

/// Unsharp masking as in a webcam's processor: the image plus `amount` times what a Gaussian blur
/// of `sigmaPx` (pixels) removes from it. It creates halos at edges.
struct Sharpening {
  double amount = 0.0;
  double sigmaPx = 1.0;
};
/// Returns the sharpened image (CV_8UC3); with an amount of 0, the image itself.
cv::Mat sharpened(const cv::Mat& image, const Sharpening& sharpening);

/// Returns the image (CV_8UC3) after JPEG compression with `quality` 1 to 100. Its colors have half
/// the resolution (4:2:0), as in the encoder's default and nearly every webcam.
cv::Mat throughJpeg(const cv::Mat& image, int quality);

/// Returns gains over the image (CV_32FC3): light that decreases toward the corners by `vignette`
/// and changes linearly by `right` and `down` from the center to the borders.
cv::Mat unevenLight(cv::Size size, double vignette, double right, double down);

} // namespace dewpoint::simulation
