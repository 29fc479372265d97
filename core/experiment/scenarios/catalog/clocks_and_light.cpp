// SPDX-License-Identifier: GPL-3.0-or-later
// S7: cameras that take their frames at different times. S8: light that changes.
#include "core/experiment/scenarios/catalog/recipes.h"
#include "core/experiment/scenarios/draft/scenario_paths.h"
#include "core/simulation/room/light.h"
#include "core/simulation/scene/rigs.h"
#include "core/simulation/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace dewpoint::experiment::scenarios {
namespace {

/// Mixes what each camera has, so that no rate or offset goes with a place.
void shuffle(std::vector<CameraClock>& clocks, RandomDraws& draws) {
  for (std::size_t i = clocks.size() - 1; i > 0; --i) {
    std::swap(clocks[i],
              clocks[static_cast<std::size_t>(draws.drawInteger(0, static_cast<int>(i)))]);
  }
}

/// Every camera is early by its own part of a frame: one by none, one by half a frame.
bool withOffsets(ScenarioDraft& draft) {
  constexpr double kMost = 0.5; // frames: cameras that free-run
  if (!addDeskBall(draft, kDefaultFrameCount)) {
    return false;
  }
  const double rate = draft.framesPerSecond;
  draft.clocks = {{rate, 0.0}, {rate, -kMost / rate}};
  while (draft.clocks.size() < draft.rig.size()) {
    draft.clocks.push_back({rate, -draft.draws.drawUniform(0.0, kMost) / rate});
  }
  shuffle(draft.clocks, draft.draws);
  return true;
}

/// The sets come at the fastest camera's rate; a slower one's frame is in the first set after it
/// was taken.
bool withRates(ScenarioDraft& draft) {
  if (!addDeskBall(draft, kDefaultFrameCount)) {
    return false;
  }
  draft.clocks = {{30.0, 0.0}, {25.0, 0.0}, {15.0, 0.0}};
  shuffle(draft.clocks, draft.draws);
  return true;
}

/// Cameras whose time stamps are wrong by up to a frame either way, while the ball moves at about
/// 1 m/s: long enough to find out by how much.
bool withUnknownClocks(ScenarioDraft& draft) {
  constexpr std::int64_t kFrames = 450; // 15 s
  constexpr double kMost = 1.0 / 30.0;  // seconds
  if (!addDeskBall(draft, kFrames, true)) {
    return false;
  }
  std::vector<double> delays;
  for (std::size_t camera = 0; camera < draft.rig.size(); ++camera) {
    delays.push_back(draft.draws.drawUniform(-kMost, kMost));
  }
  draft.isCalibrationExactWhenIdeal = false;
  draft.adjustFaults = [delays](SensingFaults& faults) {
    for (std::size_t camera = 0; camera < delays.size(); ++camera) {
      faults.cameras[camera].timing.delaySeconds = delays[camera];
    }
  };
  return true;
}

/// The light's gain `time` seconds after it begins to change: falls for two seconds, then rises for
/// two, by an equal factor per second each.
double rampGain(double time) {
  // Of levels; chosen: a cloud, down to where dark things vanish and up to where light ones are
  // cut.
  constexpr double kLow = 0.35;
  constexpr double kHigh = 4.0 * kLow;
  constexpr double kEach = 2.0; // seconds
  const double fall = std::clamp(time / kEach, 0.0, 1.0);
  const double rise = std::clamp(time / kEach - 1.0, 0.0, 1.0);
  return std::pow(kLow, fall) * std::pow(kHigh / kLow, rise);
}

bool withRamp(ScenarioDraft& draft) {
  if (!addDeskBall(draft, kDefaultFrameCount)) {
    return false;
  }
  const double begin = draft.draws.drawUniform(0.7, 1.3);
  draft.stage.light = [begin](std::size_t, double time) {
    simulation::Light light;
    light.gain.setConstant(rampGain(time - begin));
    return light;
  };
  return true;
}

bool withTemperature(ScenarioDraft& draft) {
  constexpr double kSwing = 1000.0;    // kelvin; chosen: morning to noon
  constexpr double kSwingPeriod = 6.0; // seconds: the whole run
  if (!addDeskBall(draft, kDefaultFrameCount)) {
    return false;
  }
  const double turn = kFullTurn;
  const double phase = draft.draws.drawUniform(0.0, turn);
  draft.stage.light = [turn, phase](std::size_t, double time) {
    simulation::Light light;
    light.gain = simulation::colorTemperatureGain(
        simulation::kBalancedKelvin + kSwing * std::sin(turn * time / kSwingPeriod + phase));
    return light;
  };
  return true;
}

} // namespace

std::vector<ScenarioRecipe> clockScenarios() {
  ScenarioRecipe offsets{"S7-offsets",
                         "Three cameras, each early by a different time of up to half a frame.",
                         threeCameraDeskRig()};
  offsets.complete = withOffsets;
  ScenarioRecipe rates{"S7-rates", "Three cameras with 30, 25 and 15 frames per second.",
                       threeCameraDeskRig()};
  rates.complete = withRates;
  ScenarioRecipe unknown{"S7-unknown",
                         "Three cameras whose time stamps are wrong by up to a frame.",
                         threeCameraDeskRig()};
  unknown.complete = withUnknownClocks;
  return {offsets, rates, unknown};
}

std::vector<ScenarioRecipe> lightScenarios() {
  ScenarioRecipe ramp{"S8-ramp", "The light falls to 0.35 and rises to 1.4, 4 times, within 4 s.",
                      demoRig()};
  ramp.complete = withRamp;
  ScenarioRecipe temperature{"S8-temperature",
                             "The color temperature of the light drifts between 4500 K and 6500 K.",
                             demoRig()};
  temperature.complete = withTemperature;
  return {ramp, temperature};
}

} // namespace dewpoint::experiment::scenarios
