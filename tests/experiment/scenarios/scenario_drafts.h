// SPDX-License-Identifier: GPL-3.0-or-later
// Scenarios in the making: what is drawn for them, and their images with and without it.
#pragma once

#include "core/experiment/scenarios/draft/scenario_draft.h"

#include <opencv2/core.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::tests {

using experiment::scenarios::ScenarioDraft;
using experiment::scenarios::ScenarioRecipe;
using experiment::scenarios::SensingFaults;

/// What scenarioRun() of this name and seed is made of in grade `ideal`, before its cameras get
/// the faults that it is about. Only its noise is another one.
inline ScenarioDraft draftOf(const std::vector<ScenarioRecipe>& recipes, const std::string& name,
                             std::uint64_t seed = 1) {
  static simulation::ViewCache views;
  const auto recipe = std::ranges::find(recipes, name, &ScenarioRecipe::name);
  if (recipe == recipes.end()) {
    throw std::invalid_argument("no scenario " + name);
  }
  ScenarioDraft draft{name, Grade::Ideal, seed, RandomDraws(seed, name), recipe->rig};
  draft.room = std::make_shared<const simulation::Room>(recipe->furnishing);
  for (const Camera& camera : draft.rig) {
    draft.stage.views.push_back(views.view(camera, recipe->furnishing));
  }
  if (!recipe->complete(draft)) {
    throw std::runtime_error(name + ": no position was found");
  }
  return draft;
}

/// What the scenario does to ideal cameras, time stamps and light.
inline SensingFaults faultsOf(const ScenarioDraft& draft) {
  SensingFaults faults = noFaults(draft);
  if (draft.adjustFaults) {
    draft.adjustFaults(faults);
  }
  return faults;
}

/// The draft with that done to it. `believed`, if given, gets the cameras as methods get them.
inline ScenarioDraft withFaults(ScenarioDraft draft, CameraRig* believed = nullptr) {
  RandomDraws errors(draft.seed, draft.name + " calibration");
  CameraRig rig = applyFaults(faultsOf(draft), draft, errors);
  if (believed != nullptr) {
    *believed = std::move(rig);
  }
  return draft;
}

/// An image of the draft; another `noise`, another noise of the same scene.
inline cv::Mat imageOf(const ScenarioDraft& draft, std::size_t camera, std::int64_t frame,
                       std::int64_t noise = 0) {
  return renderStage(draft.stage, camera, draft.timeOf(frame), noise);
}

/// The first target's center at a frame, meters.
inline Eigen::Vector3d centerAt(const ScenarioDraft& draft, std::int64_t frame) {
  return draft.stage.bodies.at(draft.targets.front()).path(draft.timeOf(frame));
}

} // namespace dewpoint::tests
