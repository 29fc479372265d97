// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/draft/grade_model.h"

#include "core/base/angle.h"
#include "core/experiment/scenarios/random_draws.h"
#include "core/simulation/room/light.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dewpoint::experiment::scenarios {
namespace {

// What a user's webcams are within. Where a line names no source it is chosen, by eye, so that the
// images look like those of webcams in a room.
constexpr GradeModel kRoom{
    .name = "room",
    // From the sharpest lens that a mosaic lets one see to one that is plainly out of focus.
    .psfSigmaPx = {0.5, 2.0},
    // Small pixels hold 5000 to 10000 electrons; the gain that a room's light needs leaves a part.
    .fullWellElectrons = {1000.0, 6000.0},
    .readNoiseElectrons = {2.0, 6.0}, // data sheets of small CMOS sensors
    // A step of a webcam's "gamma" setting to both sides of BT.709.
    .contrast = {0.88, 1.12},
    .sharpening = {0.2, 1.0},
    .sharpeningSigma = {0.8, 1.5},
    .jpegQuality = {40.0, 90.0}, // motion JPEG of webcams, at a narrow and at a wide bandwidth
    // The cosine to the fourth takes 43 % at 30 degrees, the corners here; cameras give some back.
    .vignette = {0.1, 0.35},
    .maxSideFalloff = 0.12,
    .exposureSeconds = {0.010, 0.033},  // indoors, up to the whole period of 30 frames per second
    .exposureOffsetStops = {-0.3, 0.3}, // a step of a camera's exposure compensation
    .initialExposureErrorStops = {-0.3, 0.3},
    .whiteBalanceStops = {-0.12, 0.12}, // 8 % of blue or red against green
    .huntingAmplitudeStops = {0.0, 0.2},
    .huntingPeriodSeconds = {2.0, 6.0},
    // Time constants of 0.13 to 0.7 s at 30 frames per second; all pairs are stable, see
    // ControlLoop.
    .exposureLoopSpeed = {0.05, 0.25},
    .exposureLoopLagFrames = {1.0, 4.0},
    // None to a lamp somewhat stronger at the ball than the room's (kLampFraction). An exposure
    // that is right for the walls then cuts the red of a ball that is lit from the camera's side.
    .sideLampFraction = {0.0, 0.8},
    .coloredLampFraction = {0.0, 0.2},
    .coloredLampKelvin = {2700.0, 9000.0}, // a warm white bulb to the sky in a window
    .shadowDepth = {0.3, 0.9},
    .shadowHalfWidth = {0.05, 0.3}, // an arm to a person
    .shadowSpeed = {0.1, 0.5},
    // Steady light to that of a fluorescent lamp on a magnetic ballast. Exposures of a period and
    // more leave a fifth of it at most.
    .flickerDepth = {0.0, 0.35},
    .readoutSeconds = {0.015, 0.030}, // webcams read out a frame in 15 to 30 ms
    .delayFrames = {0.0, 0.5}, // cameras that free-run; half a frame is the most between neighbors
    .jitterSeconds = {0.0, 0.003}, // of a host that is busy with other things
    .droppedFrameShare = {0.0, 0.02},
    .repeatedFrameShare = {0.0, 0.02},
    // Points measured with a ruler and clicked by hand: 1 to 2 pixels at the desk, with one error
    // after the other.
    .calibration = {0.005, 0.002, 0.2 * kDegree, 0.01},
    .driftRadians = {0.0, 0.001}, // up to 0.35 pixels at a focal length of 350 pixels
    .driftTimeConstantSeconds = {2.0, 20.0},
};

// The same, about one and a half times to twice as strong; chosen.
constexpr GradeModel kWild{
    .name = "wild",
    .psfSigmaPx = {0.7, 3.0},
    .fullWellElectrons = {300.0, 3000.0},
    .readNoiseElectrons = {3.0, 10.0},
    .contrast = {0.75, 1.3},
    .sharpening = {0.2, 2.0},
    .sharpeningSigma = {0.8, 2.0},
    .jpegQuality = {25.0, 80.0},
    .vignette = {0.1, 0.5},
    .maxSideFalloff = 0.25,
    .exposureSeconds = {0.010, 0.033},
    .exposureOffsetStops = {-0.7, 0.7},
    .initialExposureErrorStops = {-1.0, 1.0},
    .whiteBalanceStops = {-0.25, 0.25},
    .huntingAmplitudeStops = {0.0, 0.5},
    .huntingPeriodSeconds = {1.0, 5.0},
    .exposureLoopSpeed = {0.05, 0.3},
    .exposureLoopLagFrames = {1.0, 4.0},
    .sideLampFraction = {0.0, 1.2},
    .coloredLampFraction = {0.0, 0.4},
    .coloredLampKelvin = {2200.0, 12000.0}, // a filament that one can look into to a clear blue sky
    .shadowDepth = {0.5, 1.0},
    .shadowHalfWidth = {0.05, 0.4},
    .shadowSpeed = {0.1, 1.0},
    .flickerDepth = {0.0, 0.9}, // up to an LED lamp with hardly a capacitor
    .readoutSeconds = {0.015, 0.033},
    .delayFrames = {0.0, 0.5},
    .jitterSeconds = {0.0, 0.006},
    .droppedFrameShare = {0.0, 0.08},
    .repeatedFrameShare = {0.0, 0.08},
    .calibration = {0.01, 0.004, 0.4 * kDegree, 0.02},
    .driftRadians = {0.0, 0.003},
    .driftTimeConstantSeconds = {1.0, 10.0},
};

/// k1 and k2 (Brown's model) of lenses that keep the image monotonous to its corners; chosen: from
/// a webcam that corrects itself to a wide action camera.
constexpr std::array<std::array<double, 2>, 4> kLenses{
    {{0.0, 0.0}, {-0.08, 0.01}, {-0.15, 0.04}, {-0.25, 0.09}}};

double draw(const Range& range, RandomDraws& draws) {
  return draws.drawUniform(range.low, range.high);
}

simulation::AutomaticGain drawAutomatic(const GradeModel& model, RandomDraws& draws) {
  simulation::AutomaticGain automatic;
  automatic.exposureLoop.correctedFractionPerFrame = draw(model.exposureLoopSpeed, draws);
  automatic.exposureLoop.lagInFrames =
      static_cast<int>(std::lround(draw(model.exposureLoopLagFrames, draws)));
  /// The white balance is slower than the exposure by this factor; chosen: it must not pulse.
  constexpr double kWhiteBalanceSpeed = 0.5;
  automatic.whiteBalanceLoop.correctedFractionPerFrame =
      kWhiteBalanceSpeed * draw(model.exposureLoopSpeed, draws);
  automatic.whiteBalanceLoop.lagInFrames = automatic.exposureLoop.lagInFrames;
  automatic.exposureOffsetStops = draw(model.exposureOffsetStops, draws);
  automatic.initialExposureErrorStops = draw(model.initialExposureErrorStops, draws);
  automatic.huntingAmplitudeStops = draw(model.huntingAmplitudeStops, draws);
  automatic.huntingPeriodSeconds = draw(model.huntingPeriodSeconds, draws);
  automatic.huntingPhaseRadians = draws.drawUniform(0.0, kFullTurn);
  automatic.whiteBalanceStops[0] = draw(model.whiteBalanceStops, draws);
  automatic.whiteBalanceStops[1] = draw(model.whiteBalanceStops, draws);
  return automatic;
}

CameraTiming drawTiming(const GradeModel& model, const FaultContext& context, RandomDraws& draws) {
  CameraTiming timing;
  timing.delaySeconds = draw(model.delayFrames, draws) / context.framesPerSecond;
  timing.jitterSeconds = draw(model.jitterSeconds, draws);
  timing.droppedFrameShare = draw(model.droppedFrameShare, draws);
  timing.repeatedFrameShare = draw(model.repeatedFrameShare, draws);
  return timing;
}

/// A point beside the start of the target, `away` meters off horizontally and `up` above it.
simulation::Vector3f beside(const FaultContext& context, double away, double up,
                            RandomDraws& draws) {
  const double angle = draws.drawUniform(0.0, kFullTurn);
  const Eigen::Vector3d offset{away * std::cos(angle), away * std::sin(angle), up};
  return (context.targetStart + offset).cast<float>();
}

/// From the start of the target to a lamp, meters.
float distanceTo(const FaultContext& context, const simulation::Vector3f& lamp) {
  return (context.targetStart.cast<float>() - lamp).norm();
}

simulation::Illumination drawIllumination(const GradeModel& model, const FaultContext& context,
                                          RandomDraws& draws) {
  // Above the target's first position, meters: a table lamp or a low window, and a lamp on a wall.
  constexpr Range kSideHeight{0.1, 0.6};
  constexpr Range kWallHeight{0.8, 1.8};
  simulation::Illumination light;
  const simulation::Vector3f side =
      beside(context, context.lampDistance, draw(kSideHeight, draws), draws);
  const auto white = static_cast<float>(draw(model.sideLampFraction, draws));
  light.additionalLamps.push_back(
      {side, simulation::Vector3f::Constant(white), distanceTo(context, side)});
  const simulation::Vector3f above =
      beside(context, context.lampDistance, draw(kWallHeight, draws), draws);
  const double strength = draw(model.coloredLampFraction, draws);
  const Eigen::Vector3d tint =
      simulation::colorTemperatureGain(draw(model.coloredLampKelvin, draws));
  light.additionalLamps.push_back(
      {above, (strength * tint).cast<float>(), distanceTo(context, above)});
  simulation::MovingShadow shadow;
  const double heading = draws.drawUniform(0.0, kFullTurn);
  const Eigen::Vector3d direction{std::cos(heading), std::sin(heading), 0.0};
  shadow.direction = direction.cast<float>();
  shadow.speed = draw(model.shadowSpeed, draws);
  // It passes where the target begins at some time of the run.
  shadow.initialPosition = direction.dot(context.targetStart) -
                           shadow.speed * draws.drawUniform(0.0, context.durationSeconds);
  shadow.halfWidth = static_cast<float>(draw(model.shadowHalfWidth, draws));
  shadow.blockedFraction = static_cast<float>(draw(model.shadowDepth, draws));
  light.shadow = shadow;
  return light;
}

} // namespace

const GradeModel& gradeModel(Grade grade) {
  static const GradeModel kIdeal = [] {
    GradeModel ideal;
    ideal.name = "ideal";
    return ideal;
  }();
  if (grade == Grade::Room) {
    return kRoom;
  }
  if (grade == Grade::Wild) {
    return kWild;
  }
  return kIdeal;
}

simulation::SensorModel randomSensor(const GradeModel& model, const FaultContext& context,
                                     RandomDraws& draws) {
  simulation::SensorModel sensor;
  sensor.psfSigmaPx = draw(model.psfSigmaPx, draws);
  sensor.noise = {draw(model.fullWellElectrons, draws), draw(model.readNoiseElectrons, draws)};
  sensor.contrast = draw(model.contrast, draws);
  sensor.sharpening = {draw(model.sharpening, draws), draw(model.sharpeningSigma, draws)};
  sensor.jpegQuality = static_cast<int>(std::lround(draw(model.jpegQuality, draws)));
  const double exposure = draw(model.exposureSeconds, draws);
  sensor.shutter = {std::max(exposure, context.exposureSeconds), draw(model.readoutSeconds, draws)};
  const double angle = draw(model.driftRadians, draws);
  sensor.drift.rotation = angle * draws.drawDirection();
  sensor.drift.settleSeconds = draw(model.driftTimeConstantSeconds, draws);
  return sensor;
}

SensingFaults randomFaults(const GradeModel& model, const FaultContext& context,
                           RandomDraws& draws) {
  SensingFaults faults;
  faults.illumination = drawIllumination(model, context, draws);
  simulation::Flicker flicker;
  flicker.frequencyHz = draws.flipCoin() ? 100.0 : 120.0; // twice that of the mains
  flicker.modulationDepth = draw(model.flickerDepth, draws);
  flicker.phaseRadians = draws.drawUniform(0.0, kFullTurn);
  for (std::size_t camera = 0; camera < context.cameraCount; ++camera) {
    CameraFaults& own = faults.cameras.emplace_back();
    own.sensor = randomSensor(model, context, draws);
    own.sensor.flicker = flicker;
    own.automaticGain = drawAutomatic(model, draws);
    own.unevenLight.vignette = draw(model.vignette, draws);
    own.unevenLight.lightGainTowardRight =
        draws.drawUniform(-model.maxSideFalloff, model.maxSideFalloff);
    own.unevenLight.lightGainTowardBottom =
        draws.drawUniform(-model.maxSideFalloff, model.maxSideFalloff);
    own.timing = drawTiming(model, context, draws);
    own.calibration = model.calibration;
  }
  return faults;
}

void setRandomLenses(Grade grade, CameraRig& rig, RandomDraws& draws) {
  if (grade == Grade::Ideal) {
    return;
  }
  for (Camera& camera : rig) {
    const auto lens =
        static_cast<std::size_t>(draws.drawInteger(0, static_cast<int>(kLenses.size()) - 1));
    camera.distortion[0] = kLenses.at(lens)[0];
    camera.distortion[1] = kLenses.at(lens)[1];
  }
}

} // namespace dewpoint::experiment::scenarios
