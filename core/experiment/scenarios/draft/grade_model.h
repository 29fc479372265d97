// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/draft/sensing_faults.h"
#include "core/experiment/scenarios/scenario.h"
#include "core/simulation/sensor/usual_camera.h"

#include <Eigen/Core>

namespace dewpoint::experiment::scenarios {

/// Range from which a number is drawn uniformly.
struct Range {
  double low = 0.0;
  double high = 0.0;
};

/// Severity of the faults in a grade (level of realism). Values are drawn for each camera in each
/// run unless a comment says otherwise.
struct GradeModel {
  const char* name = "";

  // Lens and sensor.
  Range psfSigmaPx; ///< standard deviation of the lens blur, pixels
  /// Full well of the sensor (PixelNoise::fullWellElectrons) in electrons, at the gain that the
  /// light in the room requires. CameraGain::exposureGain, which also changes the noise, is
  /// relative to this gain.
  Range fullWellElectrons;
  Range readNoiseElectrons;    ///< standard deviation of the read noise, electrons
  Range contrast;              ///< SensorModel::contrast: exponent applied to the tone curve
  Range sharpening;            ///< Sharpening::amount: strength of the unsharp mask
  Range sharpeningSigma;       ///< standard deviation of the blur in the unsharp mask, pixels
  Range jpegQuality;           ///< JPEG quality of the images, 1 to 100
  Range vignette;              ///< fraction of light lost in the corners
  double maxSideFalloff = 0.0; ///< largest fraction of light gained or lost toward a border

  // Exposure and white balance.
  Range exposureSeconds; ///< exposure of each row, seconds
  Range
      exposureOffsetStops; ///< settled exposure relative to the nominal one, stops (factors of two)
  Range initialExposureErrorStops; ///< error of the exposure at frame 0, stops
  Range whiteBalanceStops;         ///< constant error of blue and red, stops
  Range huntingAmplitudeStops; ///< amplitude of a periodic error in the measured brightness, stops
  Range huntingPeriodSeconds;  ///< period of the error in the measured brightness, seconds
  /// ControlLoop::correctedFractionPerFrame: fraction of the exposure error that is corrected per
  /// /// frame.
  Range exposureLoopSpeed;
  /// ControlLoop::lagInFrames: number of frames from a measurement to its effect.
  Range exposureLoopLagFrames;

  // Light; drawn once per run.
  /// Light of a low, white lamp at the side of the target, as a fraction of full light at the
  /// target.
  Range sideLampFraction;
  /// Light of a colored lamp in the green channel, as a fraction of full light at the target.
  Range coloredLampFraction;
  Range coloredLampKelvin; ///< color temperature of the colored lamp, kelvin
  Range shadowDepth;       ///< fraction of the room lamp's light that the moving shadow blocks
  Range shadowHalfWidth;   ///< half width of the moving shadow, meters
  Range shadowSpeed;       ///< speed of the moving shadow, m/s
  Range flickerDepth; ///< amplitude of the flicker (100 or 120 Hz) as a fraction of the mean light

  // Time.
  Range readoutSeconds;     ///< time from the first to the last row of a rolling shutter
  Range delayFrames;        ///< part of the camera's delay that methods do not know, frames
  Range jitterSeconds;      ///< standard deviation of the errors of the time stamps, seconds
  Range droppedFrameShare;  ///< fraction of frames that do not arrive
  Range repeatedFrameShare; ///< fraction of frames that repeat the previous image

  // Calibration.
  CalibrationError calibration;   ///< standard deviations of the errors of the calibration
  Range driftRadians;             ///< final rotation of the camera since its calibration, radians
  Range driftTimeConstantSeconds; ///< time constant of the rotation since the calibration, seconds
};

/// Default horizontal distance of additional lamps from the target's initial position, meters. It
/// is chosen so that the lamps are inside the walls of the room with the desk (kDeskRoomHalfSize)
/// and behind the cameras.
inline constexpr double kLampDistance = 1.5;

/// Returns the severity of the faults in a grade (level of realism). All values of grade `Ideal`
/// are zero.
const GradeModel& gradeModel(Grade grade);

/// Properties of a run on which its random faults depend.
struct FaultContext {
  std::size_t cameraCount = 0;
  double durationSeconds = 6.0; ///< duration of the run
  double framesPerSecond = simulation::kDefaultFrameRate;
  double exposureSeconds = simulation::kDefaultExposureSeconds; ///< shortest exposure, seconds
  /// Initial position of the first target, world, meters.
  Eigen::Vector3d targetStart = Eigen::Vector3d::Zero();
  double lampDistance =
      kLampDistance; ///< horizontal distance of additional lamps from targetStart, meters
};

/// Draws all faults of a run at random: the faults of its cameras and of its light.
SensingFaults randomFaults(const GradeModel& model, const FaultContext& context,
                           RandomDraws& draws);

/// Draws the sensor model of one camera, from its lens to its video stream, without flicker and
/// automatic exposure.
simulation::SensorModel randomSensor(const GradeModel& model, const FaultContext& context,
                                     RandomDraws& draws);

/// Gives each camera a lens that is typical of consumer cameras. In the grade (level of realism)
/// `Ideal`, cameras remain pinhole cameras. There are only a few different lenses to draw from,
/// because runs with the same lenses share rendered backgrounds.
void setRandomLenses(Grade grade, CameraRig& rig, RandomDraws& draws);

} // namespace dewpoint::experiment::scenarios
