// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/draft/sensing_faults.h"
#include "core/experiment/scenarios/scenario.h"
#include "core/simulation/sensor/usual_camera.h"

#include <Eigen/Core>

namespace dewpoint::experiment::scenarios {

/// A number is drawn uniformly between these.
struct Range {
  double low = 0.0;
  double high = 0.0;
};

/// How rough a grade is: what is drawn per camera and run, except where a line says otherwise.
/// A camera's automatics, lens and clock are its own; lamps and shadow are the room's.
struct GradeModel {
  const char* name = "";

  // Lens and sensor.
  Range psfSigmaPx;      ///< blur, pixels
  Range fullWell;        ///< electrons at full scale with the gain that the light needs
  Range readElectrons;   ///< standard deviation
  Range contrast;        ///< exponent upon the tone curve
  Range sharpening;      ///< amount of the unsharp mask
  Range sharpeningSigma; ///< pixels
  Range jpegQuality;
  Range vignette;           ///< light lost in the corners
  double sideFalloff = 0.0; ///< light gained or lost towards a border, at most

  // Exposure and white balance.
  Range exposureSeconds;
  Range levelStops;        ///< where the exposure settles
  Range firstStops;        ///< its error at frame 0
  Range whiteBalanceStops; ///< lasting error of blue and of red
  Range huntingStops;      ///< amplitude of what misleads the meter
  Range huntingPeriod;     ///< seconds
  Range loopSpeed;         ///< share of the error corrected per frame
  Range loopLag;           ///< frames

  // Light; drawn once per run.
  Range sideLamp;        ///< white, low, from the side; of full light, at the target
  Range coloredLamp;     ///< of full light in green, at the target
  Range coloredKelvin;   ///< its color temperature
  Range shadowDepth;     ///< share of the room's lamp that the moving shadow takes
  Range shadowHalfWidth; ///< meters
  Range shadowSpeed;     ///< m/s
  Range flickerDepth;    ///< amplitude, of the mean light; 100 or 120 Hz

  // Time.
  Range readoutSeconds; ///< rolling shutter
  Range delayFrames;    ///< unknown delay
  Range jitterSeconds;  ///< of time stamps
  Range dropShare;
  Range doubleShare;

  // Calibration.
  CalibrationError calibration; ///< standard deviations
  Range driftRadians;           ///< that the camera rotates by in the end, after the calibration
  Range driftSettleSeconds;
};

/// Horizontal distance of lamps besides the room's own from the target's first position, meters:
/// chosen, so that they stand inside the walls of the room with the desk (kDeskRoomHalf) and behind
/// the cameras.
inline constexpr double kLampDistance = 1.5;

/// The table of a grade; `Ideal` has none of it: all zeros.
const GradeModel& gradeModel(Grade grade);

/// What a run looks like, as far as faults depend on it.
struct FaultContext {
  std::size_t cameras = 0;
  double seconds = 6.0; ///< length of the run
  double framesPerSecond = simulation::kUsualFrameRate;
  double exposureSeconds = simulation::kUsualExposure; ///< the least
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();    ///< where the first target begins, world, m
  double lampDistance = kLampDistance; ///< of further lamps from there, horizontally, meters
};

/// Faults of a run in a grade.
SensingFaults drawFaults(const GradeModel& model, const FaultContext& context, Draws& draws);

/// One camera of a grade from its lens to its stream, without flicker and automatics.
simulation::SensorModel drawSensor(const GradeModel& model, const FaultContext& context,
                                   Draws& draws);

/// Gives each camera one of the lenses of consumer cameras; `Ideal` leaves pinholes. There are only
/// few, so that runs can share backgrounds.
void drawLenses(Grade grade, CameraRig& rig, Draws& draws);

} // namespace dewpoint::experiment::scenarios
