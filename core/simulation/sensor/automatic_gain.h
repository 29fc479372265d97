// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/sensor/usual_camera.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace dewpoint::simulation {

/// Control loop in a camera for one quantity, such as the exposure: a slow integrator whose
/// corrections take effect after a delay. Errors and corrections are in stops: one stop is a factor
/// of two. The defaults are chosen so that the loop settles within half a second without overshoot.
struct ControlLoop {
  double correctedFractionPerFrame =
      0.15;                        ///< fraction of the error corrected per frame; 0: no control
  int lagInFrames = 2;             ///< number of frames from a measurement to its effect
  double deadbandStops = 0.03;     ///< errors below this value are not corrected; stops
  double maxCorrectionStops = 1.5; ///< limit of the correction in both directions, stops
};

/// Returns the corrections with which the loop compensates for a disturbance, such as a change of
/// the light. Disturbance and corrections are in stops, with one entry per frame; 0 means no
/// disturbance. The first correction is `start`. Fast loops with a long lag overshoot. The loop is
/// stable if correctedFractionPerFrame < 2 sin(pi / (4 lagInFrames + 2)).
std::vector<double> simulateControlLoop(const ControlLoop& loop,
                                        std::span<const double> disturbance, double start);

/// Gain factors for linear light that a camera's automatic control sets for one frame.
struct CameraGain {
  double exposureGain = 1.0; ///< exposure gain, applied before noise
  Eigen::Vector3d whiteBalance =
      Eigen::Vector3d::Ones(); ///< white balance gains, BGR, applied after noise; green is 1
};

/// Gains of a camera over a run. The gains of the last frame also apply to later times.
struct GainCurve {
  double framesPerSecond = kDefaultFrameRate;
  std::vector<CameraGain> gainPerFrame; ///< empty: all gains are 1
  /// Returns the gains at a time in seconds.
  CameraGain gainAt(double time) const;
};

/// Automatic exposure and white balance of one camera. In the first frame, both are already settled
/// for the light, except for the errors that the fields describe.
struct AutomaticGain {
  ControlLoop exposureLoop;
  ControlLoop whiteBalanceLoop;
  double initialExposureErrorStops = 0.0; ///< error of the exposure at frame 0, stops
  double exposureOffsetStops = 0.0; ///< settled exposure relative to the nominal exposure, stops
  /// Amplitude of a periodic error in the measured brightness, stops. The error imitates objects
  /// that enter and leave the image.
  double huntingAmplitudeStops = 0.0;
  double huntingPeriodSeconds = 4.0; ///< period of the error `huntingAmplitudeStops`, seconds
  double huntingPhaseRadians = 0.0;  ///< phase of the error `huntingAmplitudeStops`, radians
  /// Constant errors of the white balance in blue and red, stops.
  Eigen::Vector2d whiteBalanceStops = Eigen::Vector2d::Zero();
};

/// Returns the gains of a run, one entry per frame. `lightStops` contains, for each frame, the
/// light per channel (BGR) relative to the nominal light, in stops. The result depends only on the
/// arguments.
GainCurve automaticGains(const AutomaticGain& control, std::span<const Eigen::Vector3d> lightStops,
                         double framesPerSecond);

} // namespace dewpoint::simulation
