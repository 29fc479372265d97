// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/sensor/automatic_gain.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace dewpoint::simulation {
namespace {

/// The correction of the white balance for one channel against green.
std::vector<double> balanced(const AutomaticGain& control,
                             std::span<const Eigen::Vector3d> lightStops, int channel,
                             double lasting) {
  std::vector<double> tint;
  tint.reserve(lightStops.size());
  for (const Eigen::Vector3d& stops : lightStops) {
    tint.push_back(stops[channel] - stops[1] - lasting);
  }
  return simulateControlLoop(control.whiteBalanceLoop, tint,
                             tint.empty() ? lasting : -tint.front());
}

} // namespace

std::vector<double> simulateControlLoop(const ControlLoop& loop,
                                        std::span<const double> disturbance, double start) {
  std::vector<double> result;
  result.reserve(disturbance.size());
  double now = start;
  for (std::size_t frame = 0; frame < disturbance.size(); ++frame) {
    result.push_back(now);
    const auto lag = static_cast<std::size_t>(loop.lagInFrames);
    const std::size_t measured = frame > lag ? frame - lag : 0;
    const double error = disturbance[measured] + result[measured];
    if (std::abs(error) > loop.deadbandStops) {
      now = std::clamp(now - loop.correctedFractionPerFrame * error, -loop.maxCorrectionStops,
                       loop.maxCorrectionStops);
    }
  }
  return result;
}

CameraGain GainCurve::gainAt(double time) const {
  if (gainPerFrame.empty()) {
    return {};
  }
  const double last = static_cast<double>(gainPerFrame.size() - 1);
  const double frame = std::clamp(std::round(time * framesPerSecond), 0.0, last);
  return gainPerFrame[static_cast<std::size_t>(frame)];
}

GainCurve automaticGains(const AutomaticGain& control, std::span<const Eigen::Vector3d> lightStops,
                         double framesPerSecond) {
  const double turn = 2.0 * std::numbers::pi / (control.huntingPeriodSeconds * framesPerSecond);
  std::vector<double> metered;
  metered.reserve(lightStops.size());
  for (std::size_t frame = 0; frame < lightStops.size(); ++frame) {
    const double angle = turn * static_cast<double>(frame) + control.huntingPhaseRadians;
    metered.push_back(lightStops[frame][1] - control.exposureOffsetStops +
                      control.huntingAmplitudeStops * std::sin(angle));
  }
  const double settled = lightStops.empty() ? 0.0 : control.exposureOffsetStops - lightStops[0][1];
  const auto exposure = simulateControlLoop(control.exposureLoop, metered,
                                            settled + control.initialExposureErrorStops);
  const auto blue = balanced(control, lightStops, 0, control.whiteBalanceStops[0]);
  const auto red = balanced(control, lightStops, 2, control.whiteBalanceStops[1]);
  GainCurve curve;
  curve.framesPerSecond = framesPerSecond;
  curve.gainPerFrame.reserve(lightStops.size());
  for (std::size_t frame = 0; frame < lightStops.size(); ++frame) {
    curve.gainPerFrame.push_back(
        {std::exp2(exposure[frame]), {std::exp2(blue[frame]), 1.0, std::exp2(red[frame])}});
  }
  return curve;
}

} // namespace dewpoint::simulation
