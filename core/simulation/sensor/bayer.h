// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"

#include <opencv2/core.hpp>

namespace dewpoint::simulation {

/// Noise of a pixel by the photon transfer model (Janesick, "Photon Transfer", 2007): the variance
/// of the number of electrons equals their number, and reading them adds further noise.
struct PixelNoise {
  double fullWell = 0.0;      ///< number of electrons at full scale with a gain of 1
  double readElectrons = 0.0; ///< standard deviation of the read noise, electrons
};

/// Returns the signal of the pixels under a color filter array: CV_32FC1 from linear light
/// (CV_32FC3, BGR). Rows begin with red green, then green blue (RGGB). Red and blue pixels are less
/// sensitive than green ones, as with silicon behind color filters.
cv::Mat mosaic(const cv::Mat& linear);

/// Adds noise to `raw` (CV_32FC1, 1 is full scale): its variance, in squared full scales, is
/// (raw + read^2 / electrons) / electrons, with `electrons` at full scale = fullWell / gain.
void addPixelNoise(cv::Mat& raw, const PixelNoise& noise, double gain, const RandomStream& stream);

/// Returns colors for all pixels from the mosaic: quantization to 12 bits, bilinear interpolation
/// of the missing colors (OpenCV's), and division by the sensitivities of mosaic(). CV_32FC3, BGR.
cv::Mat demosaiced(const cv::Mat& raw);

} // namespace dewpoint::simulation
