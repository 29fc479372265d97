// SPDX-License-Identifier: GPL-3.0-or-later
// S14: what a webcam makes of the light, and nothing else.
#include "core/experiment/scenarios/catalog/recipes.h"
#include "core/experiment/scenarios/draft/grade_model.h"
#include "core/experiment/scenarios/draft/scenario_paths.h"
#include "core/simulation/scene/scene.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace dewpoint::experiment::scenarios {
namespace {

/// Lens, mosaic, noise, sharpening and JPEG of cameras of grade `room`; the tone curve is the
/// nominal one, shutter, time and calibration are ideal. A grade that has cameras of its own keeps
/// those.
bool withWebcams(ScenarioDraft& draft, bool fast) {
  if (!addDeskBall(draft, kDefaultFrameCount, fast)) {
    return false;
  }
  if (draft.grade != Grade::Ideal) {
    return true;
  }
  std::vector<simulation::SensorModel> webcams;
  for (std::size_t camera = 0; camera < draft.rig.size(); ++camera) {
    webcams.push_back(randomSensor(gradeModel(Grade::Room), {}, draft.draws));
  }
  draft.adjustFaults = [webcams](SensingFaults& faults) {
    for (std::size_t camera = 0; camera < webcams.size(); ++camera) {
      simulation::SensorModel& sensor = faults.cameras[camera].sensor;
      const simulation::SensorModel& webcam = webcams[camera];
      sensor.psfSigmaPx = webcam.psfSigmaPx;
      sensor.noise = webcam.noise;
      sensor.sharpening = webcam.sharpening;
      sensor.jpegQuality = webcam.jpegQuality;
    }
  };
  return true;
}

} // namespace

std::vector<ScenarioRecipe> sensorScenarios() {
  ScenarioRecipe slow{"S14-slow",
                      "The smooth path seen by webcams: blur, Bayer mosaic, shot noise, "
                      "sharpening, JPEG; all else is ideal.",
                      demoRig()};
  slow.complete = [](ScenarioDraft& draft) { return withWebcams(draft, false); };
  ScenarioRecipe fast{"S14-fast", "The same, five times as fast.", demoRig()};
  fast.complete = [](ScenarioDraft& draft) { return withWebcams(draft, true); };
  return {slow, fast};
}

} // namespace dewpoint::experiment::scenarios
