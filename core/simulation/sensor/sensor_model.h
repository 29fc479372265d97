// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/simulation/sensor/automatic_gain.h"
#include "core/simulation/sensor/bayer.h"
#include "core/simulation/sensor/camera_drift.h"
#include "core/simulation/sensor/sensor.h"
#include "core/simulation/sensor/shutter.h"

#include <opencv2/core.hpp>

namespace dewpoint::simulation {

/// Model of a camera from its lens to its image stream. The default is an ideal camera: a global
/// shutter of 10 ms, sharp images, true colors for every pixel, and no compression.
struct SensorModel {
  Shutter shutter;
  Flicker flicker; ///< flicker of the light; its effect depends on the shutter
  CameraDrift drift;
  GainCurve gainCurve;     ///< automatic exposure and white balance over the run
  double psfSigmaPx = 0.0; ///< standard deviation of the lens blur (Gaussian), pixels
  /// Noise of the pixels under a color filter array; if `fullWellElectrons` is 0, the sensor has no
  /// such array and no such noise.
  PixelNoise noise;
  double contrast = 1.0; ///< exponent applied to the nominal tone curve
  Sharpening sharpening;
  int jpegQuality = 0; ///< quality of the JPEG compression, 1 to 100; 0: no compression

  /// Returns whether the model changes the light before it is converted to gray levels.
  bool changesLight() const;
};

/// Returns the image (CV_8UC3) that a camera sends. `light` is the image that falls on an ideal
/// sensor at `time` (seconds): CV_32FC3, BGR, in the renderer's gray levels. The function applies
/// blur, flicker, exposure, Bayer mosaic with its noise, white balance, tone curve, sharpening and
/// JPEG, in this order. If PixelNoise::fullWellElectrons is 0, normal noise with a standard
/// deviation of `noiseSigma` gray levels is used instead of the mosaic and its noise.
cv::Mat sensorImage(const cv::Mat& light, const SensorModel& model, double time, double noiseSigma,
                    const RandomStream& stream);

} // namespace dewpoint::simulation
