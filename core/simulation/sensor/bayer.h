// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"

#include <opencv2/core.hpp>

namespace dewpoint::simulation {

/// Noise of a pixel by the photon transfer model (Janesick, "Photon Transfer", 2007): electrons are
/// counted with the variance of their number, and reading them adds more.
struct PixelNoise {
  double fullWell = 0.0;      ///< electrons that give full scale at a gain of 1
  double readElectrons = 0.0; ///< standard deviation of the read noise, electrons
};

/// What the pixels under a color filter array get: CV_32FC1 from linear light (CV_32FC3, BGR).
/// Rows begin with red green, then green blue (RGGB). Red and blue pixels get less of their light
/// than green ones of theirs, as silicon behind color filters does.
cv::Mat mosaic(const cv::Mat& linear);

/// Adds noise to `raw` (CV_32FC1, 1 is full scale): its variance, in squared full scales, is
/// (raw + read^2 / electrons) / electrons, with `electrons` at full scale = fullWell / gain.
void addPixelNoise(cv::Mat& raw, const PixelNoise& noise, double gain, const RandomStream& stream);

/// Colors for all pixels again: digits of 12 bits, bilinear interpolation of the missing colors
/// (OpenCV's), and the sensitivities of mosaic() divided out. CV_32FC3, BGR.
cv::Mat demosaiced(const cv::Mat& raw);

} // namespace dewpoint::simulation
