// SPDX-License-Identifier: GPL-3.0-or-later
// S5: identical balls, all of which are to be tracked, whose ways cross.
#include "core/experiment/scenarios/catalog/recipes.h"
#include "core/experiment/scenarios/draft/scenario_paths.h"
#include "core/simulation/scene/rigs.h"

#include <algorithm>

namespace dewpoint::experiment::scenarios {
namespace {

/// Between the centers of two balls, meters; chosen: half a radius is between them.
constexpr double kLeastDistance = 2.5 * kBallRadius;
// Seconds; chosen: 2.5 rounds in the shorter scenarios. All go round in the same time: what does
// not touch in the first round never does, however long the run is.
constexpr double kPeriod = 8.0;

/// Far enough from all balls that are there, and beside them in every image of the first frame.
bool keepsClear(const ScenarioDraft& draft, const LissajousPath& path) {
  const auto clear = [&](const simulation::StageBody& body) {
    for (std::int64_t frame = 0; draft.timeOf(frame) < kPeriod; ++frame) {
      const double time = draft.timeOf(frame);
      if ((body.path(time) - path(time)).norm() < kLeastDistance) {
        return false;
      }
    }
    return std::ranges::all_of(draft.stage.views, [&](const auto& view) {
      return areSeparated(*view, body.path(0.0), kBallRadius, path(0.0), kBallRadius);
    });
  };
  return std::ranges::all_of(draft.stage.bodies, clear);
}

bool addBall(ScenarioDraft& draft) {
  RandomDraws& draws = draft.draws;
  for (int i = 0; i < kMaxDrawAttempts; ++i) {
    LissajousPath path;
    path.center = draws.drawPointInBox({0.36, 0.36, 0.12}, {0.64, 0.64, 0.26});
    path.extent = draws.drawPointInBox({0.08, 0.08, 0.02}, {0.2, 0.16, 0.08});
    path.phase =
        draws.drawPointInBox(Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(kFullTurn));
    path.periodSeconds = kPeriod;
    if (keepsClear(draft, path) && staysVisible(draft, path, kBallRadius)) {
      addTarget(draft, path, kBallRadius);
      return true;
    }
  }
  return false;
}

bool crossing(ScenarioDraft& draft, std::size_t count, std::int64_t frames) {
  // Some first paths leave no room for so many more: begin again.
  draft.frameCount = frames;
  for (int layout = 0; layout < kMaxLayoutAttempts; ++layout) {
    draft.stage.bodies.clear();
    draft.targets.clear();
    while (draft.targets.size() < count && addBall(draft)) {
    }
    if (draft.targets.size() == count) {
      startAroundAllTargets(draft);
      return true;
    }
  }
  return false;
}

} // namespace

std::vector<ScenarioRecipe> crossingScenarios() {
  const auto recipe = [](const char* name, const char* sentence, std::size_t count,
                         std::int64_t frames) {
    ScenarioRecipe result{name, sentence, deskRingRig(4)};
    result.complete = [=](ScenarioDraft& draft) { return crossing(draft, count, frames); };
    return result;
  };
  return {recipe("S5-two", "Two identical balls on crossing paths, 20 s.", 2, 600),
          recipe("S5-four", "Four identical balls on crossing paths, 20 s.", 4, 600),
          recipe("S5-eight", "Eight identical balls on crossing paths, 2 minutes.", 8, 3600)};
}

} // namespace dewpoint::experiment::scenarios
