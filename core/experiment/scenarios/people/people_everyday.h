// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/people/people_scenario.h"
#include "core/experiment/scenarios/random_draws.h"

namespace dewpoint::experiment {

// Scenes of people beyond those of the paper. Functions named draw... add people with their paths
// and set the times at which identities are assessed. Functions named ...Possible report whether
// people could walk these paths. Functions named give... and take... change a scene whose people
// are already dressed.

/// Adds three people who walk around, not near each other.
void drawStrolls(PeopleScenario& scenario, Draws& draws);
bool strollsPossible(const PeopleScenario& scenario);
/// Sets the heights of the strolling people: a child of 0.9 to 1.3 m, a person of 1.3 to 1.6 m, and
/// a person of 1.88 to 2 m.
void giveHeights(PeopleScenario& scenario, PeopleClothes clothes, Draws& draws);

/// Adds one person who sits down on a stool and stands up, one who crouches, and one who walks
/// past.
void drawSitting(PeopleScenario& scenario, Draws& draws);
bool sittingPossible(const PeopleScenario& scenario);
/// Adds the stool, with a height that suits the person. It is present from the beginning.
void giveStool(PeopleScenario& scenario, PeopleClothes clothes, Draws& draws);

/// Gives the first person a box and the second a bag.
void giveLoads(PeopleScenario& scenario, PeopleClothes clothes, Draws& draws);

/// Adds five to eight people who walk around for 12 s. Their paths may touch and cross.
void drawCrowd(PeopleScenario& scenario, Draws& draws);
bool crowdPossible(const PeopleScenario& scenario);
/// Sets heights of 1.5 to 2 m for the people in the crowd.
void giveCrowdHeights(PeopleScenario& scenario, PeopleClothes clothes, Draws& draws);

/// Keeps only two cameras, either neighboring or opposite.
void takeCameras(PeopleScenario& scenario, PeopleClothes clothes, Draws& draws);

/// Adds two people who walk around. A cabinet and a stool that were present while the cameras
/// learned the background slide to other positions, as if on casters, after the people have
/// appeared.
void drawMovedFurniture(PeopleScenario& scenario, Draws& draws);
bool movedFurniturePossible(const PeopleScenario& scenario);

} // namespace dewpoint::experiment
