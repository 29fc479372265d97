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

/// Severity of the faults in a grade. Values are drawn per camera and run unless a comment says
/// otherwise. Automatic exposure, lens and clock belong to one camera. Lamps and shadow belong to
/// the room.
struct GradeModel {
  const char* name = "";

  // Lens and sensor.
  Range psfSigmaPx;      ///< blur, pixels
  Range fullWell;        ///< electrons at full scale, at the gain that the light requires
  Range readElectrons;   ///< standard deviation
  Range contrast;        ///< exponent applied to the tone curve
  Range sharpening;      ///< amount of the unsharp mask
  Range sharpeningSigma; ///< pixels
  Range jpegQuality;
  Range vignette;           ///< fraction of light lost in the corners
  double sideFalloff = 0.0; ///< largest fraction of light gained or lost toward a border

  // Exposure and white balance.
  Range exposureSeconds;
  Range levelStops;        ///< level at which the exposure settles
  Range firstStops;        ///< error of the exposure at frame 0
  Range whiteBalanceStops; ///< constant error of blue and red
  Range huntingStops;      ///< amplitude of the disturbance of the exposure meter
  Range huntingPeriod;     ///< seconds
  Range loopSpeed;         ///< fraction of the error corrected per frame
  Range loopLag;           ///< delay of the correction, frames

  // Light; drawn once per run.
  Range sideLamp;        ///< white, low, from the side; fraction of full light at the target
  Range coloredLamp;     ///< fraction of full light at the target, in green
  Range coloredKelvin;   ///< color temperature of that lamp, kelvin
  Range shadowDepth;     ///< fraction of the room lamp's light that the moving shadow blocks
  Range shadowHalfWidth; ///< meters
  Range shadowSpeed;     ///< m/s
  Range flickerDepth;    ///< amplitude as a fraction of the mean light; 100 or 120 Hz

  // Time.
  Range readoutSeconds; ///< rolling shutter
  Range delayFrames;    ///< unknown delay
  Range jitterSeconds;  ///< standard deviation of the time stamps
  Range dropShare;
  Range doubleShare;

  // Calibration.
  CalibrationError calibration; ///< standard deviations
  Range driftRadians;           ///< final rotation of the camera after calibration
  Range driftSettleSeconds;
};

/// Horizontal distance of additional lamps from the target's initial position, meters. It is chosen
/// so that the lamps are inside the walls of the room with the desk (kDeskRoomHalfSize) and behind
/// the cameras.
inline constexpr double kLampDistance = 1.5;

/// Returns the values of a grade. `Ideal` has no faults: all zeros.
const GradeModel& gradeModel(Grade grade);

/// Properties of a run on which its faults depend.
struct FaultContext {
  std::size_t cameras = 0;
  double seconds = 6.0; ///< duration of the run
  double framesPerSecond = simulation::kDefaultFrameRate;
  double exposureSeconds = simulation::kDefaultExposureSeconds; ///< shortest exposure, seconds
  /// Initial position of the first target, world, meters.
  Eigen::Vector3d targetStart = Eigen::Vector3d::Zero();
  double lampDistance =
      kLampDistance; ///< horizontal distance of additional lamps from targetStart, meters
};

/// Draws the faults of a run.
SensingFaults randomFaults(const GradeModel& model, const FaultContext& context,
                           RandomDraws& draws);

/// Draws the image pipeline of one camera, from lens to video stream, excluding flicker and
/// automatic exposure.
simulation::SensorModel randomSensor(const GradeModel& model, const FaultContext& context,
                                     RandomDraws& draws);

/// Gives each camera a lens typical of consumer cameras. `Ideal` keeps pinholes. There are only a
/// few lenses, so that runs can share backgrounds.
void setRandomLenses(Grade grade, CameraRig& rig, RandomDraws& draws);

} // namespace dewpoint::experiment::scenarios
