// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"

#include <opencv2/core.hpp>

namespace dewpoint::simulation {

/// Converts light (CV_32FC3, BGR, [0, 255]) to a sensor image (CV_8UC3). Adds normal noise with a
/// standard deviation of `noiseSigma` gray levels, drawn from `stream`.
cv::Mat digitize(const cv::Mat& image, double noiseSigma, const RandomStream& stream);

/// Unsharp masking, as in a webcam's processor: the detail that a Gaussian blur of `sigmaPx` pixels
/// removes is multiplied by `amount` and added to the image. This creates halos at edges.
struct Sharpening {
  double amount = 0.0;
  double sigmaPx = 1.0;
};
/// Returns the sharpened image (CV_8UC3). With an amount of 0, returns the image itself.
cv::Mat sharpened(const cv::Mat& image, const Sharpening& sharpening);

/// Returns the image (CV_8UC3) after JPEG compression with `quality` from 1 to 100. Colors have
/// half the resolution (4:2:0), as in nearly every webcam.
cv::Mat jpegCompressed(const cv::Mat& image, int quality);

/// Returns the gain of each pixel (CV_32FC3) for uneven light. The light decreases toward the
/// corners by the fraction `vignette`, and changes linearly from the center to the right and lower
/// borders by the fractions `right` and `down`.
cv::Mat unevenLightGains(cv::Size size, double vignette, double right, double down);

} // namespace dewpoint::simulation
