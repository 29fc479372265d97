// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

namespace dewpoint::observation {

/// D = max(g * M, p_B): the motion likelihood image of Mohedano et al. 2009, equation 8, CV_32FC1,
/// of a mask M (CV_8UC1, 0 or 255). g is a Gaussian of `sigma` pixels, cut off at three of them;
/// nothing moves outside the image.
void motionLikelihood(const cv::Mat& mask, double sigma, double floor, cv::Mat& likelihood);

/// The color cue of the same paper, equations 10 to 13.
struct ColorCue {
  double hueSigma = 0.04;        ///< sigma_h, of a hue in [0, 1]
  double saturationSigma = 0.08; ///< sigma_s
  double hueFloor = 0.3;         ///< h_B
  double saturationFloor = 0.3;  ///< s_B

  /// log p(H | h) p(S | s) of a pixel (BGR). A gray pixel has no hue: its p(H) is the mean over all
  /// hues, h_B + (1 - h_B), which is 1.
  double logLikelihood(const unsigned char* bgr, double hue, double saturation) const;
  /// log(h_B s_B): the least that logLikelihood() gives, for a color that does not match at all.
  double logFloor() const;
};

/// Hue and saturation of a pixel in [0, 1] (HSI); the hue is NaN for gray.
Eigen::Vector2d hueAndSaturation(const unsigned char* bgr);

/// The nearest pixel to a projection; false when that is outside, or the projection is NaN.
bool nearestPixel(double column, double row, const cv::Mat& image, cv::Point& pixel);

} // namespace dewpoint::observation
