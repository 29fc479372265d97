// SPDX-License-Identifier: GPL-3.0-or-later
// S12: balls with patches, seams, two colors or a clipped highlight, which rotate.
#include "core/experiment/scenarios/catalog/recipes.h"
#include "core/experiment/scenarios/draft/scenario_paths.h"
#include "core/experiment/scenarios/targets/patterned_ball.h"
#include "core/simulation/scene/scene.h"

namespace dewpoint::experiment::scenarios {
namespace {

bool patterned(ScenarioDraft& draft, BallPattern pattern) {
  if (!addDeskBall(draft, kDefaultFrameCount)) {
    return false;
  }
  const Spin spin = randomSpin(draft.draws, kSlowestSpin, kFastestSpin);
  paintBall(draft.stage.bodies.back(), pattern, spin, draft.draws);
  return true;
}

} // namespace

std::vector<ScenarioRecipe> patternedBallScenarios() {
  const auto recipe = [](const char* name, const char* sentence, BallPattern pattern) {
    ScenarioRecipe result{name, sentence, demoRig()};
    result.complete = [pattern](ScenarioDraft& draft) { return patterned(draft, pattern); };
    return result;
  };
  return {
      recipe("S12-one-patch", "A rotating ball with one white or dark patch.",
             BallPattern::OnePatch),
      recipe("S12-two-patches", "The same with two large patches.", BallPattern::TwoPatches),
      recipe("S12-three-patches", "The same with three large patches, like a beach ball.",
             BallPattern::ThreePatches),
      recipe("S12-six-spots", "The same with six small spots.", BallPattern::SixSpots),
      recipe("S12-seams", "The same with two crossing seams.", BallPattern::Seams),
      recipe("S12-two-colors", "Half of the rotating ball has another color.",
             BallPattern::TwoColors),
      recipe("S12-highlight", "A shiny ball with a clipped highlight.", BallPattern::Highlight),
  };
}

} // namespace dewpoint::experiment::scenarios
