// SPDX-License-Identifier: GPL-3.0-or-later
// S16: a calibration that is not right, or no longer, and nothing else.
#include "core/experiment/scenarios/catalog/recipes.h"
#include "core/experiment/scenarios/draft/grade_model.h"
#include "core/experiment/scenarios/draft/scenario_paths.h"
#include "core/simulation/scene/scene.h"

#include <cstddef>
#include <vector>

namespace dewpoint::experiment::scenarios {
namespace {

/// What a camera rotates by in the end, radians: 0.35 to 1 pixel at a focal length of 350 pixels;
/// chosen: one to three times the most of grade `room`, so that it can be seen alone.
constexpr Range kDrift{0.001, 0.003};
/// Its time constant, seconds; chosen: most of it happens within the run.
constexpr Range kSettle{1.5, 4.0};

bool withCalibration(ScenarioDraft& draft, bool error, bool drift) {
  if (!addDeskBall(draft, kDefaultFrameCount)) {
    return false;
  }
  std::vector<simulation::CameraDrift> drifts;
  for (std::size_t camera = 0; camera < draft.rig.size(); ++camera) {
    const double angle = draft.draws.drawUniform(kDrift.low, kDrift.high);
    const Eigen::Vector3d axis = draft.draws.drawDirection();
    drifts.push_back({angle * axis, draft.draws.drawUniform(kSettle.low, kSettle.high)});
  }
  draft.isCalibrationExactWhenIdeal = false;
  const bool ideal = draft.grade == Grade::Ideal;
  draft.adjustFaults = [=](SensingFaults& faults) {
    for (std::size_t camera = 0; camera < drifts.size(); ++camera) {
      CameraFaults& own = faults.cameras[camera];
      if (error && ideal) {
        own.calibration = gradeModel(Grade::Room).calibration;
      }
      if (drift) {
        own.sensor.drift = drifts[camera];
      }
    }
  };
  return true;
}

} // namespace

std::vector<ScenarioRecipe> driftScenarios() {
  const auto recipe = [](const char* name, const char* sentence, bool error, bool drift) {
    ScenarioRecipe result{name, sentence, demoRig()};
    result.complete = [=](ScenarioDraft& draft) { return withCalibration(draft, error, drift); };
    return result;
  };
  return {recipe("S16-calibration", "The calibration is as wrong as one by hand.", true, false),
          recipe("S16-drift",
                 "The cameras slowly rotate away from their calibration, by 0.35 to 1 "
                 "pixel.",
                 false, true),
          recipe("S16-both", "A calibration by hand, and cameras that rotate away from it.", true,
                 true)};
}

} // namespace dewpoint::experiment::scenarios
