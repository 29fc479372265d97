// SPDX-License-Identifier: GPL-3.0-or-later
// S20: light that is not that of one white lamp, and exposures that are not fixed.
#include "core/experiment/scenarios/catalog/recipes.h"
#include "core/experiment/scenarios/draft/grade_model.h"
#include "core/experiment/scenarios/draft/scenario_paths.h"
#include "core/simulation/room/light.h"
#include "core/simulation/scene/scene.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace dewpoint::experiment::scenarios {
namespace {

/// A lamp kLampDistance beside the first target's first position, `up` meters above it, that lights
/// everything as much.
simulation::AdditionalLamp lampBeside(ScenarioDraft& draft, double up,
                                      const Eigen::Vector3d& color) {
  const double angle = draft.draws.drawUniform(0.0, kFullTurn);
  const Eigen::Vector3d middle = draft.stage.bodies[draft.targets.front()].path(0.0);
  const Eigen::Vector3d position = middle + Eigen::Vector3d(kLampDistance * std::cos(angle),
                                                            kLampDistance * std::sin(angle), up);
  return {position.cast<float>(), color.cast<float>()};
}

/// The side towards a low lamp gets 3 to 4 times the light of the other and is cut at full scale.
bool withSideLight(ScenarioDraft& draft) {
  constexpr float kRoomGain = 0.6F; // of the room's light; chosen: the lamp outshines it
  if (!addDeskBall(draft, kDefaultFrameCount)) {
    return false;
  }
  const double strength = draft.draws.drawUniform(1.0, 1.2);
  const double up = draft.draws.drawUniform(0.1, 0.5);
  const auto lamp = lampBeside(draft, up, Eigen::Vector3d::Constant(strength));
  draft.adjustFaults = [lamp](SensingFaults& faults) {
    faults.illumination.roomGain = kRoomGain;
    faults.illumination.additionalLamps = {lamp};
  };
  return true;
}

/// A warm bulb or the blue sky of a window beside the lamp that the cameras are balanced for.
bool withColoredLamp(ScenarioDraft& draft) {
  constexpr float kRoomGain = 0.8F; // of the room's light; chosen: with the lamp about as light
  if (!addDeskBall(draft, kDefaultFrameCount)) {
    return false;
  }
  // Kelvin: bulbs of 2700 to 3500 K, blue sky of 8000 to 10000 K. Strengths of full light.
  const double kelvin = draft.draws.flipCoin() ? draft.draws.drawUniform(2700.0, 3500.0)
                                               : draft.draws.drawUniform(8e3, 10e3);
  const double strength = draft.draws.drawUniform(0.3, 0.5);
  const double up = draft.draws.drawUniform(0.3, 1.5);
  const auto lamp = lampBeside(draft, up, strength * simulation::colorTemperatureGain(kelvin));
  draft.adjustFaults = [lamp](SensingFaults& faults) {
    faults.illumination.roomGain = kRoomGain;
    faults.illumination.additionalLamps = {lamp};
  };
  return true;
}

/// Exposure and white balance that jump every 0.7 to 1.3 s, each camera's for itself.
simulation::GainCurve drawSteps(ScenarioDraft& draft) {
  // Stops to both sides; chosen: about twice those of grade `room`, all at once.
  constexpr double kExposure = 0.7;
  constexpr double kWhiteBalance = 0.2;
  RandomDraws& draws = draft.draws;
  simulation::GainCurve curve;
  curve.framesPerSecond = draft.framesPerSecond;
  while (static_cast<std::int64_t>(curve.gainPerFrame.size()) < draft.frameCount) {
    simulation::CameraGain gain;
    if (!curve.gainPerFrame.empty()) {
      gain.exposureGain = std::exp2(draws.drawUniform(-kExposure, kExposure));
      gain.whiteBalance[0] = std::exp2(draws.drawUniform(-kWhiteBalance, kWhiteBalance));
      gain.whiteBalance[2] = std::exp2(draws.drawUniform(-kWhiteBalance, kWhiteBalance));
    }
    curve.gainPerFrame.insert(curve.gainPerFrame.end(),
                              static_cast<std::size_t>(draws.drawInteger(20, 40)), gain);
  }
  return curve;
}

bool withExposureSteps(ScenarioDraft& draft) {
  if (!addDeskBall(draft, kDefaultFrameCount)) {
    return false;
  }
  std::vector<simulation::GainCurve> curves;
  for (std::size_t camera = 0; camera < draft.rig.size(); ++camera) {
    curves.push_back(drawSteps(draft));
  }
  draft.adjustFaults = [curves](SensingFaults& faults) {
    for (std::size_t camera = 0; camera < curves.size(); ++camera) {
      faults.cameras[camera].sensor.gainCurve = curves[camera];
    }
  };
  return true;
}

/// Lamps on 50 Hz, short exposures, and the rolling shutters without which there are no bands.
bool withFlicker(ScenarioDraft& draft) {
  constexpr double kExposureSeconds = 0.004; // chosen: well below the light's period of 10 ms
  if (!addDeskBall(draft, kDefaultFrameCount)) {
    return false;
  }
  const Range& readout = gradeModel(Grade::Room).readoutSeconds;
  simulation::Flicker flicker;
  flicker.modulationDepth = draft.draws.drawUniform(0.2, 0.4);
  flicker.phaseRadians = draft.draws.drawUniform(0.0, kFullTurn);
  std::vector<simulation::Shutter> shutters;
  for (std::size_t camera = 0; camera < draft.rig.size(); ++camera) {
    shutters.push_back({kExposureSeconds, draft.draws.drawUniform(readout.low, readout.high)});
  }
  draft.adjustFaults = [=](SensingFaults& faults) {
    for (std::size_t camera = 0; camera < shutters.size(); ++camera) {
      faults.cameras[camera].sensor.flicker = flicker;
      faults.cameras[camera].sensor.shutter = shutters[camera];
    }
  };
  return true;
}

/// The shadow passes where the ball is at some time between seconds 1.5 and 4.5.
bool withMovingShadow(ScenarioDraft& draft) {
  if (!addDeskBall(draft, kDefaultFrameCount)) {
    return false;
  }
  RandomDraws& draws = draft.draws;
  simulation::MovingShadow shadow;
  const double heading = draws.drawUniform(0.0, kFullTurn);
  const Eigen::Vector3d direction{std::cos(heading), std::sin(heading), 0.0};
  const double when = draws.drawUniform(1.5, 4.5);
  shadow.direction = direction.cast<float>();
  shadow.speed = draws.drawUniform(0.1, 0.4);
  const Eigen::Vector3d ball = draft.stage.bodies[draft.targets.front()].path(when);
  shadow.initialPosition = direction.dot(ball) - shadow.speed * when;
  shadow.halfWidth = static_cast<float>(draws.drawUniform(0.05, 0.2));
  shadow.blockedFraction = static_cast<float>(draws.drawUniform(0.8, 1.0));
  draft.adjustFaults = [shadow](SensingFaults& faults) { faults.illumination.shadow = shadow; };
  return true;
}

} // namespace

std::vector<ScenarioRecipe> lampScenarios() {
  const auto recipe = [](const char* name, const char* sentence, bool (*complete)(ScenarioDraft&)) {
    ScenarioRecipe result{name, sentence, demoRig()};
    result.complete = complete;
    return result;
  };
  return {
      recipe("S20-side-light", "A strong lamp from one side: half of the ball is overexposed.",
             withSideLight),
      recipe("S20-second-lamp", "A second lamp of another color.", withColoredLamp),
      recipe("S20-exposure-steps",
             "Exposure and white balance of each camera jump about once a second.",
             withExposureSteps),
      recipe("S20-flicker", "Lamps on 50 Hz and rolling shutters: bands of light.", withFlicker),
      recipe("S20-shadow", "A shadow passes over the ball, the desk and the walls.",
             withMovingShadow)};
}

} // namespace dewpoint::experiment::scenarios
