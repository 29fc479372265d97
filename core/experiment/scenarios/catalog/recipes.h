// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/draft/scenario_draft.h"

#include <vector>

namespace dewpoint::experiment::scenarios {

// Each of the following functions returns the scenarios of one family in report order. The comment
// behind each function is the name of the family.
std::vector<ScenarioRecipe> cleanScenarios();          ///< S0
std::vector<ScenarioRecipe> distractorScenarios();     ///< S1
std::vector<ScenarioRecipe> occlusionScenarios();      ///< S2
std::vector<ScenarioRecipe> blackoutScenarios();       ///< S3
std::vector<ScenarioRecipe> startScenarios();          ///< S4
std::vector<ScenarioRecipe> crossingScenarios();       ///< S5
std::vector<ScenarioRecipe> cameraScenarios();         ///< S6
std::vector<ScenarioRecipe> clockScenarios();          ///< S7
std::vector<ScenarioRecipe> lightScenarios();          ///< S8
std::vector<ScenarioRecipe> movedCameraScenarios();    ///< S9
std::vector<ScenarioRecipe> unknownSizeScenarios();    ///< S10
std::vector<ScenarioRecipe> handHeldTargetScenarios(); ///< S11
std::vector<ScenarioRecipe> patternedBallScenarios();  ///< S12
std::vector<ScenarioRecipe> posterScenarios();         ///< S13
std::vector<ScenarioRecipe> sensorScenarios();         ///< S14
std::vector<ScenarioRecipe> timingScenarios();         ///< S15
std::vector<ScenarioRecipe> driftScenarios();          ///< S16
std::vector<ScenarioRecipe> outOfViewScenarios();      ///< S17
std::vector<ScenarioRecipe> thrownBallScenarios();     ///< S18
std::vector<ScenarioRecipe> crowdScenarios();          ///< S19
std::vector<ScenarioRecipe> lampScenarios();           ///< S20
std::vector<ScenarioRecipe> shapeScenarios();          ///< S21
std::vector<ScenarioRecipe> clickedTargetScenarios();  ///< S22

} // namespace dewpoint::experiment::scenarios
