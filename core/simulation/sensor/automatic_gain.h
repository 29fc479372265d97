// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/sensor/usual_camera.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace dewpoint::simulation {

/// A camera's control of one quantity: a slow integrator that sees its own effect late. The
/// defaults are chosen: settled within half a second, without overshooting.
struct ControlLoop {
  double speed = 0.15;    ///< share of the error corrected per frame; 0: no control
  int lagFrames = 2;      ///< from a measurement to its effect
  double deadband = 0.03; ///< stops (factors of two): smaller errors are left alone
  double limit = 1.5;     ///< stops to both sides of 0 that the control can reach
};

/// The correction at every frame, in stops, of a disturbance (stops, one per frame; 0: none)
/// that the loop wants to cancel; the first is `start`. Fast loops with a long lag overshoot.
/// Stable while speed < 2 sin(pi / (4 lag + 2)) (the discrete integrator with delay).
std::vector<double> corrections(const ControlLoop& loop, std::span<const double> disturbance,
                                double start);

/// What a camera's automatics set for one frame: factors on linear light.
struct CameraGain {
  double exposure = 1.0;                                  ///< before noise
  Eigen::Vector3d whiteBalance = Eigen::Vector3d::Ones(); ///< BGR, after noise; green is 1
};

/// Gains over a run; after the last frame they stay.
struct GainCurve {
  double framesPerSecond = kUsualFrameRate;
  std::vector<CameraGain> frames; ///< none: all gains are 1
  CameraGain at(double time) const;
};

/// Automatic exposure and white balance of one camera, settled in the light of the first frame but
/// for the errors below.
struct AutomaticGain {
  ControlLoop exposure;
  ControlLoop whiteBalance;
  double firstStops = 0.0;    ///< error of the exposure at frame 0, stops
  double levelStops = 0.0;    ///< what the exposure settles at, stops from the nominal one
  double huntingStops = 0.0;  ///< amplitude of what misleads the meter (objects that come and go)
  double huntingPeriod = 4.0; ///< seconds
  double huntingPhase = 0.0;  ///< radians
  Eigen::Vector2d whiteBalanceStops = Eigen::Vector2d::Zero(); ///< lasting error of blue and red
};

/// The gains of a run in light whose channels (BGR) are `lightStops` stops from the nominal, one
/// per frame. A function of its arguments only.
GainCurve automaticGains(const AutomaticGain& control, std::span<const Eigen::Vector3d> lightStops,
                         double framesPerSecond);

} // namespace dewpoint::simulation
