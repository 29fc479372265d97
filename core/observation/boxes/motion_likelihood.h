// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

namespace dewpoint::observation {

/// Computes the motion likelihood image D = max(g * M, p_B) of a mask M (CV_8UC1, 0 or 255), as
/// CV_32FC1 (Mohedano et al. 2009, equation 8). g is a Gaussian with a standard deviation of
/// `sigma` pixels, truncated at three standard deviations. `floor` is p_B. Pixels outside the image
/// count as not moving.
void computeMotionLikelihood(const cv::Mat& mask, double sigma, double floor, cv::Mat& likelihood);

/// Color likelihood of a pixel for a person with a given hue and saturation (Mohedano et al. 2009,
/// equations 10 to 13).
struct ColorCue {
  /// Standard deviation of the hue, which is in [0, 1]; sigma_h in the paper.
  double hueSigma = 0.04;
  /// Standard deviation of the saturation, which is in [0, 1]; sigma_s in the paper.
  double saturationSigma = 0.08;
  /// Lowest likelihood of a hue; h_B in the paper.
  double minHueLikelihood = 0.3;
  /// Lowest likelihood of a saturation; s_B in the paper.
  double minSaturationLikelihood = 0.3;

  /// Returns the log likelihood log(p(H | h) p(S | s)) of a pixel (BGR) with hue H and saturation
  /// S, where h is `hue` and s is `saturation`. A gray pixel has no hue. For such a pixel, p(H | h)
  /// is replaced by its mean over all hues, h_B + (1 - h_B) = 1, where h_B is `minHueLikelihood`.
  double logLikelihood(const unsigned char* bgr, double hue, double saturation) const;
  /// Returns the smallest value of logLikelihood(), which is the value for a color that does not
  /// match at all: the logarithm of the product of the two lowest likelihoods.
  double minLogLikelihoodPerPixel() const;
};

/// Returns the hue and saturation (HSI) of a pixel, in [0, 1]. The hue is NaN for gray.
Eigen::Vector2d hueAndSaturation(const unsigned char* bgr);

/// Finds the pixel nearest to a projection (`column`, `row`). Returns false if the projection is
/// outside the image or NaN.
bool findNearestPixel(double column, double row, const cv::Mat& image, cv::Point& pixel);

} // namespace dewpoint::observation
