// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/catalog/catalog.h"

#include "core/experiment/scenarios/catalog/recipes.h"
#include "core/experiment/scenarios/draft/scenario_draft.h"

namespace dewpoint::experiment {

const std::vector<ScenarioDeclaration>& scenarioCatalog() {
  static const std::vector<ScenarioDeclaration> catalog = [] {
    const auto cache = std::make_shared<simulation::ViewCache>();
    std::vector<ScenarioDeclaration> all;
    for (const auto& family :
         {scenarios::cleanScenarios(),         scenarios::distractorScenarios(),
          scenarios::occlusionScenarios(),     scenarios::blackoutScenarios(),
          scenarios::startScenarios(),         scenarios::crossingScenarios(),
          scenarios::cameraScenarios(),        scenarios::clockScenarios(),
          scenarios::lightScenarios(),         scenarios::movedCameraScenarios(),
          scenarios::unknownSizeScenarios(),   scenarios::handHeldTargetScenarios(),
          scenarios::patternedBallScenarios(), scenarios::posterScenarios(),
          scenarios::sensorScenarios(),        scenarios::timingScenarios(),
          scenarios::driftScenarios(),         scenarios::outOfViewScenarios(),
          scenarios::thrownBallScenarios(),    scenarios::crowdScenarios(),
          scenarios::lampScenarios(),          scenarios::shapeScenarios(),
          scenarios::clickedTargetScenarios()}) {
      for (const auto& recipe : family) {
        all.push_back(scenarios::declareScenario(recipe, cache));
      }
    }
    return all;
  }();
  return catalog;
}

} // namespace dewpoint::experiment
