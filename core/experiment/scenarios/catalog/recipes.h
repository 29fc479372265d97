// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/draft/scenario_draft.h"

#include <vector>

namespace dewpoint::experiment::scenarios {

// Each of the following functions returns the scenarios of one family in report order. The comment
// behind each function states the name and the difficulty of the family.
std::vector<ScenarioRecipe> cleanScenarios();          ///< S0: one ball, no difficulty
std::vector<ScenarioRecipe> distractorScenarios();     ///< S1: target among identical balls
std::vector<ScenarioRecipe> occlusionScenarios();      ///< S2: plate hides half of the ball
std::vector<ScenarioRecipe> blackoutScenarios();       ///< S3: cameras blind or ball gone
std::vector<ScenarioRecipe> startScenarios();          ///< S4: search starts far away or ball jumps
std::vector<ScenarioRecipe> crossingScenarios();       ///< S5: identical balls cross
std::vector<ScenarioRecipe> cameraScenarios();         ///< S6: 2 to 8 cameras, or failing ones
std::vector<ScenarioRecipe> clockScenarios();          ///< S7: cameras not synchronous
std::vector<ScenarioRecipe> lightScenarios();          ///< S8: light changes
std::vector<ScenarioRecipe> movedCameraScenarios();    ///< S9: one camera is moved
std::vector<ScenarioRecipe> unknownSizeScenarios();    ///< S10: ball size not known
std::vector<ScenarioRecipe> handHeldTargetScenarios(); ///< S11: hand covers part of the ball
std::vector<ScenarioRecipe> patternedBallScenarios();  ///< S12: ball with a pattern or highlight
std::vector<ScenarioRecipe> posterScenarios();         ///< S13: poster of the target's color
std::vector<ScenarioRecipe> sensorScenarios();         ///< S14: sensor faults of webcams
std::vector<ScenarioRecipe> timingScenarios();         ///< S15: timing faults of cameras
std::vector<ScenarioRecipe> driftScenarios();          ///< S16: wrong or drifting calibration
std::vector<ScenarioRecipe> outOfViewScenarios();      ///< S17: ball leaves the images
std::vector<ScenarioRecipe> thrownBallScenarios();     ///< S18: ball is thrown or bounces
std::vector<ScenarioRecipe> crowdScenarios();          ///< S19: identical balls fly around
std::vector<ScenarioRecipe> lampScenarios();           ///< S20: lamps, shadow, exposure jumps
std::vector<ScenarioRecipe> shapeScenarios();          ///< S21: targets other than balls
std::vector<ScenarioRecipe> clickedTargetScenarios();  ///< S22: color learned from one click

} // namespace dewpoint::experiment::scenarios
