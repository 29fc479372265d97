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

/// A camera from its lens to the stream that it sends. The default is an ideal one: a global
/// shutter of 10 ms, sharp, true colors for every pixel, nothing compressed.
struct SensorModel {
  Shutter shutter;
  Flicker flicker; ///< of the light, which every shutter sees in its own way
  CameraDrift drift;
  GainCurve gains;         ///< automatic exposure and white balance over the run
  double psfSigmaPx = 0.0; ///< blur of the lens: a Gaussian, pixels
  PixelNoise noise;        ///< with a full well: a color filter array and its noise
  double contrast = 1.0;   ///< exponent upon the nominal tone curve
  Sharpening sharpening;
  int jpegQuality = 0; ///< 1 to 100; 0: not compressed

  /// True where something happens to the light before it becomes numbers.
  bool worksOnLight() const;
};

/// The image (CV_8UC3) that a camera sends of `light`: CV_32FC3, BGR, in the renderer's levels, as
/// it falls on an ideal sensor at `time`. Blur, flicker, exposure, Bayer mosaic with its noise,
/// white balance, tone curve, sharpening, JPEG, in this order. A model without a full well gets
/// normal noise of `noiseSigma` levels in the end instead.
cv::Mat sensorImage(const cv::Mat& light, const SensorModel& model, double time, double noiseSigma,
                    const RandomStream& stream);

} // namespace dewpoint::simulation
