// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/sensor/sensor_model.h"

#include "core/simulation/sensor/optics.h"
#include "core/simulation/sensor/tone_curve.h"

#include <cstddef>

namespace dewpoint::simulation {
namespace {

/// Each row times its own gain.
void multiplyRows(cv::Mat& image, const std::vector<float>& gains) {
  for (int row = 0; row < image.rows; ++row) {
    cv::Mat line = image.row(row);
    line *= gains[static_cast<std::size_t>(row)];
  }
}

/// From the light on the sensor to levels (CV_32FC3) before the last noise and rounding.
cv::Mat processed(const cv::Mat& light, const SensorModel& model, double time,
                  const RandomStream& stream) {
  const CameraGain gain = model.gainCurve.gainAt(time);
  cv::Mat linear = blurred(linearImage(light), model.psfSigmaPx);
  if (model.flicker.modulationDepth > 0.0) {
    multiplyRows(linear, rowGains(model.flicker, model.shutter, linear.rows, time));
  }
  linear *= gain.exposureGain;
  if (model.noise.fullWellElectrons > 0.0) {
    cv::Mat raw = bayerMosaic(linear);
    addPixelNoise(raw, model.noise, gain.exposureGain, stream);
    linear = demosaiced(raw);
  }
  return applyToneCurve(linear, gain.whiteBalance, model.contrast);
}

} // namespace

bool SensorModel::changesLight() const {
  return psfSigmaPx > 0.0 || noise.fullWellElectrons > 0.0 || flicker.modulationDepth > 0.0 ||
         contrast != 1.0 || !gainCurve.gainPerFrame.empty();
}

cv::Mat sensorImage(const cv::Mat& light, const SensorModel& model, double time, double noiseSigma,
                    const RandomStream& stream) {
  const cv::Mat levels = model.changesLight() ? processed(light, model, time, stream) : light;
  const bool noisy = model.noise.fullWellElectrons > 0.0;
  const cv::Mat image =
      sharpened(digitize(levels, noisy ? 0.0 : noiseSigma, stream), model.sharpening);
  return model.jpegQuality > 0 ? jpegCompressed(image, model.jpegQuality) : image;
}

} // namespace dewpoint::simulation
