// SPDX-License-Identifier: GPL-3.0-or-later
// S15: frames that are not from when their time stamps say, and nothing else.
#include "core/experiment/scenarios/catalog/recipes.h"
#include "core/experiment/scenarios/draft/grade_model.h"
#include "core/experiment/scenarios/draft/scenario_paths.h"
#include "core/simulation/scene/scene.h"

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace dewpoint::experiment::scenarios {
namespace {

/// The readout of rolling shutters, seconds, and unknown delays, frames: those of grade `room`.
bool withRollingShutters(ScenarioDraft& draft, bool fast) {
  if (!addDeskBall(draft, kDefaultFrameCount, fast)) {
    return false;
  }
  const Range& range = gradeModel(Grade::Room).readoutSeconds;
  std::vector<double> readouts;
  for (std::size_t camera = 0; camera < draft.rig.size(); ++camera) {
    readouts.push_back(draft.draws.drawUniform(range.low, range.high));
  }
  draft.isCalibrationExactWhenIdeal = false;
  draft.adjustFaults = [readouts](SensingFaults& faults) {
    for (std::size_t camera = 0; camera < readouts.size(); ++camera) {
      faults.cameras[camera].sensor.shutter.readoutSeconds = readouts[camera];
    }
  };
  return true;
}

bool withUnknownDelays(ScenarioDraft& draft, bool fast) {
  if (!addDeskBall(draft, kDefaultFrameCount, fast)) {
    return false;
  }
  const Range& range = gradeModel(Grade::Room).delayFrames;
  std::vector<double> delays;
  for (std::size_t camera = 0; camera < draft.rig.size(); ++camera) {
    delays.push_back(draft.draws.drawUniform(range.low, range.high) / draft.framesPerSecond);
  }
  draft.isCalibrationExactWhenIdeal = false;
  draft.adjustFaults = [delays](SensingFaults& faults) {
    for (std::size_t camera = 0; camera < delays.size(); ++camera) {
      faults.cameras[camera].timing.delaySeconds = delays[camera];
    }
  };
  return true;
}

/// As over a busy USB bus or network; chosen: five times the most of grade `room`.
bool withDroppedAndDoubled(ScenarioDraft& draft) {
  constexpr double kShare = 0.1; // of the frames, each
  if (!addDeskBall(draft, kDefaultFrameCount)) {
    return false;
  }
  draft.isCalibrationExactWhenIdeal = false;
  draft.adjustFaults = [](SensingFaults& faults) {
    for (CameraFaults& camera : faults.cameras) {
      camera.timing.droppedFrameShare = kShare;
      camera.timing.repeatedFrameShare = kShare;
    }
  };
  return true;
}

/// One camera shows one image for a second, as a driver that hangs: its time stamps go on.
bool withFrozenStream(ScenarioDraft& draft) {
  constexpr std::int64_t kFrozen = 30; // frames: a second
  if (!addDeskBall(draft, kDefaultFrameCount)) {
    return false;
  }
  const std::int64_t begin = 75 + draft.draws.drawInteger(-15, 15);
  const auto frozen =
      static_cast<std::size_t>(draft.draws.drawInteger(0, static_cast<int>(draft.rig.size()) - 1));
  draft.isCalibrationExactWhenIdeal = false;
  draft.adjustFaults = [=](SensingFaults& faults) {
    faults.cameras[frozen].timing.freezeBegin = begin;
    faults.cameras[frozen].timing.freezeEnd = begin + kFrozen;
  };
  return true;
}

/// Clocks that go wrong by 0.2 % at most, either way: in the 6 s of the run up to 12 ms, as much as
/// crystals that differ by 100 millionths in two minutes.
bool withDriftingClocks(ScenarioDraft& draft) {
  constexpr double kDrift = 0.002;
  if (!addDeskBall(draft, kDefaultFrameCount)) {
    return false;
  }
  std::vector<double> drifts;
  for (std::size_t camera = 0; camera < draft.rig.size(); ++camera) {
    drifts.push_back(draft.draws.drawUniform(-kDrift, kDrift));
  }
  draft.isCalibrationExactWhenIdeal = false;
  draft.adjustFaults = [drifts](SensingFaults& faults) {
    for (std::size_t camera = 0; camera < drifts.size(); ++camera) {
      faults.cameras[camera].timing.clockDrift = drifts[camera];
    }
  };
  return true;
}

} // namespace

std::vector<ScenarioRecipe> timingScenarios() {
  const auto recipe = [](const char* name, const char* sentence,
                         std::function<bool(ScenarioDraft&)> complete) {
    ScenarioRecipe result{name, sentence, demoRig()};
    result.complete = std::move(complete);
    return result;
  };
  return {
      recipe("S15-rolling-slow", "The smooth path seen through rolling shutters of 15 to 30 ms.",
             [](ScenarioDraft& draft) { return withRollingShutters(draft, false); }),
      recipe("S15-rolling-fast", "The same, five times as fast.",
             [](ScenarioDraft& draft) { return withRollingShutters(draft, true); }),
      recipe("S15-offsets-slow",
             "Each camera is early by a different, unknown time of up to half a frame.",
             [](ScenarioDraft& draft) { return withUnknownDelays(draft, false); }),
      recipe("S15-offsets-fast", "The same, five times as fast.",
             [](ScenarioDraft& draft) { return withUnknownDelays(draft, true); }),
      recipe("S15-dropped", "One frame in ten is missing, and one in ten repeats the frame before.",
             withDroppedAndDoubled),
      recipe("S15-frozen", "One camera shows the same image for 1 s, with new time stamps.",
             withFrozenStream),
      recipe("S15-clock-drift", "The cameras' clocks are up to 0.2 % fast or slow.",
             withDriftingClocks)};
}

} // namespace dewpoint::experiment::scenarios
