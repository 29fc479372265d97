// SPDX-License-Identifier: GPL-3.0-or-later
// S0: one ball on a cluttered desk, nothing else of its color. S1: balls that look the same.
// S10: the same with a ball whose size methods are not told.
#include "core/experiment/scenarios/catalog/recipes.h"
#include "core/experiment/scenarios/draft/scenario_paths.h"
#include "core/simulation/scene/scene.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace dewpoint::experiment::scenarios {
namespace {

/// Least distance of a distractor to the target, meters; chosen: a radius is between them.
constexpr double kDistractorDistance = 3.0 * kBallRadius;

/// Radii of balls of unknown size, meters: that of a walnut to that of an orange.
constexpr double kSmallest = 0.02;
constexpr double kLargest = 0.045;

bool cleanDesk(ScenarioDraft& draft, bool fast) {
  return addDeskBall(draft, kDefaultFrameCount, fast);
}

/// What hides the target is S2's matter: a twin before the target leaves its middle free.
bool leavesTargetVisible(const simulation::RoomView& view, const Eigen::Vector3d& target,
                         const Eigen::Vector3d& distractor) {
  const Eigen::Vector3d eye = view.center.cast<double>();
  return (distractor - eye).norm() > (target - eye).norm() ||
         areSeparated(view, target, 0.0, distractor, kBallRadius);
}

bool seenSomewhere(const simulation::Stage& stage, const Eigen::Vector3d& center) {
  for (const auto& view : stage.views) {
    if (isFullyVisible(*view, center, kBallRadius)) {
      return true;
    }
  }
  return false;
}

/// Never near any other ball, never in a camera, never hides the target.
bool isPossible(const ScenarioDraft& draft, const LissajousPath& distractor) {
  for (std::int64_t frame = 0; frame < draft.frameCount; ++frame) {
    const double time = draft.timeOf(frame);
    const Eigen::Vector3d position = distractor(time);
    for (const simulation::StageBody& body : draft.stage.bodies) {
      if ((body.path(time) - position).norm() < kDistractorDistance) {
        return false;
      }
    }
    const Eigen::Vector3d target = draft.stage.bodies[draft.targets.front()].path(time);
    for (const auto& view : draft.stage.views) {
      const bool begins =
          frame > 0 || areSeparated(*view, target, kBallRadius, position, kBallRadius);
      if (!begins || !leavesTargetVisible(*view, target, position)) {
        return false;
      }
    }
  }
  return seenSomewhere(draft.stage, distractor.center);
}

bool addDistractor(ScenarioDraft& draft, bool moving) {
  RandomDraws& draws = draft.draws;
  for (int i = 0; i < kMaxDrawAttempts; ++i) {
    LissajousPath distractor;
    distractor.center =
        draws.drawPointInBox({0.25, 0.3, moving ? 0.1 : kBallRadius}, {0.85, 0.85, 0.3});
    if (!moving && draws.flipCoin()) {
      distractor.center.z() = kBallRadius; // on the desk
    }
    if (moving) {
      distractor.extent = draws.drawUniform(0.6, 1.1) * Eigen::Vector3d{0.09, 0.07, 0.05};
      distractor.phase =
          draws.drawPointInBox(Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(kFullTurn));
      distractor.periodSeconds = draws.drawUniform(4.0, 9.0);
    }
    if (isPossible(draft, distractor)) {
      simulation::StageBody& body = draft.stage.bodies.emplace_back();
      body.name = fmt::format("twin {}", draft.stage.bodies.size() - 1);
      body.radius = kBallRadius;
      body.path = distractor;
      return true;
    }
  }
  return false;
}

bool amongDistractors(ScenarioDraft& draft, int count, bool moving) {
  // Some targets' paths leave no room for so many twins: draw the path again as well.
  constexpr int kPaths = 20;
  for (int attempt = 0; attempt < kPaths; ++attempt) {
    draft.stage.bodies.clear();
    draft.targets.clear();
    if (!cleanDesk(draft, false)) {
      return false;
    }
    int placed = 0;
    while (placed < count && addDistractor(draft, moving)) {
      ++placed;
    }
    if (placed == count) {
      return true;
    }
  }
  return false;
}

/// The ball of the clean desk, of any size; methods must find it out.
bool ofUnknownSize(ScenarioDraft& draft, int distractors) {
  if (distractors > 0 ? !amongDistractors(draft, distractors, false) : !cleanDesk(draft, false)) {
    return false;
  }
  const double radius = draft.draws.drawUniform(kSmallest, kLargest);
  for (simulation::StageBody& body : draft.stage.bodies) {
    body.radius = radius;
  }
  draft.isRadiusKnown = false;
  return true;
}

} // namespace

std::vector<ScenarioRecipe> cleanScenarios() {
  ScenarioRecipe slow{"S0-slow", "One ball on a smooth path, 0.1 to 0.3 m/s.", demoRig()};
  slow.complete = [](ScenarioDraft& draft) { return cleanDesk(draft, false); };
  ScenarioRecipe fast{"S0-fast", "The same kind of path, five times as fast.", demoRig()};
  fast.complete = [](ScenarioDraft& draft) { return cleanDesk(draft, true); };
  return {slow, fast};
}

std::vector<ScenarioRecipe> distractorScenarios() {
  std::vector<ScenarioRecipe> recipes;
  for (const bool moving : {false, true}) {
    for (int count = 1; count <= 5; ++count) {
      ScenarioRecipe recipe{fmt::format("S1-{}-{}", moving ? "moving" : "still", count),
                            fmt::format("The smooth path among {} identical {}.", count,
                                        moving ? "balls on paths of their own" : "balls at rest"),
                            demoRig()};
      recipe.complete = [count, moving](ScenarioDraft& draft) {
        return amongDistractors(draft, count, moving);
      };
      recipes.push_back(std::move(recipe));
    }
  }
  return recipes;
}

std::vector<ScenarioRecipe> unknownSizeScenarios() {
  ScenarioRecipe clean{"S10-clean", "The smooth path; the size of the ball is not given.",
                       demoRig()};
  clean.complete = [](ScenarioDraft& draft) { return ofUnknownSize(draft, 0); };
  ScenarioRecipe distractors{"S10-still-3", "The same among 3 identical balls at rest.", demoRig()};
  distractors.complete = [](ScenarioDraft& draft) { return ofUnknownSize(draft, 3); };
  return {clean, distractors};
}

} // namespace dewpoint::experiment::scenarios
