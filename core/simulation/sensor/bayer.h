// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"

#include <opencv2/core.hpp>

namespace dewpoint::simulation {

/// Pixel noise according to the photon transfer model (Janesick, "Photon Transfer", 2007). The
/// variance of the number of electrons equals its mean. Reading out the electrons adds more noise.
struct PixelNoise {
  /// Number of electrons at full scale with a gain of 1, that is, at the nominal exposure of the
  /// scene (CameraGain::exposureGain).
  double fullWellElectrons = 0.0;
  double readNoiseElectrons = 0.0; ///< standard deviation of the read noise, electrons
};

/// Returns the signal of a sensor whose pixels lie under a color filter array (CV_32FC1). `linear`
/// is the linear light on the sensor (CV_32FC3, BGR). Rows alternate between red-green and
/// green-blue (RGGB). Red and blue pixels are less sensitive than green pixels, as in real sensors.
cv::Mat bayerMosaic(const cv::Mat& linear);

/// Adds noise to `raw` (CV_32FC1, 1 is full scale). The variance of the noise, relative to the
/// squared full scale, is (raw + read^2 / electrons) / electrons. Here, electrons =
/// fullWellElectrons / gain is the number of electrons at full scale, and read is
/// PixelNoise::readNoiseElectrons.
void addPixelNoise(cv::Mat& raw, const PixelNoise& noise, double gain, const RandomStream& stream);

/// Returns the colors of all pixels (CV_32FC3, BGR), reconstructed from a mosaic `raw` (CV_32FC1).
/// The steps are quantization to 12 bits, OpenCV's bilinear interpolation of the missing colors,
/// and division by the sensitivities of bayerMosaic().
cv::Mat demosaiced(const cv::Mat& raw);

} // namespace dewpoint::simulation
