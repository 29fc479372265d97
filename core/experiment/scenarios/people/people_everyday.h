// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/people/people_scenario.h"
#include "core/experiment/scenarios/random_draws.h"

namespace dewpoint::experiment {

// Scenes of people beyond those of the paper. draw... adds people with their paths and sets when
// identities are assessed; ...Possible reports whether people could have walked these paths;
// give... and take... change a scene whose people are dressed.

/// Adds three people who walk about, not near each other.
void drawStrolls(PeopleScenario& scenario, Draws& draws);
bool strollsPossible(const PeopleScenario& scenario);
/// Sets their heights: a child of 0.9 to 1.3 m, a person of 1.3 to 1.6 m, and a person of 1.88 to 2
/// m.
void giveHeights(PeopleScenario& scenario, PeopleClothes clothes, Draws& draws);

/// Adds one person who sits down on a stool and stands up, one who crouches, and one who walks
/// past.
void drawSitting(PeopleScenario& scenario, Draws& draws);
bool sittingPossible(const PeopleScenario& scenario);
/// Adds the stool, as high as fits the person and present from the beginning.
void giveStool(PeopleScenario& scenario, PeopleClothes clothes, Draws& draws);

/// Gives the first person a box and the second a bag.
void giveLoads(PeopleScenario& scenario, PeopleClothes clothes, Draws& draws);

/// Adds five to eight people who mill about for 12 s; their paths may touch and cross.
void drawCrowd(PeopleScenario& scenario, Draws& draws);
bool crowdPossible(const PeopleScenario& scenario);
/// Sets heights of 1.5 to 2 m.
void giveCrowdHeights(PeopleScenario& scenario, PeopleClothes clothes, Draws& draws);

/// Keeps only two of the cameras, neighbors or opposite ones.
void takeCameras(PeopleScenario& scenario, PeopleClothes clothes, Draws& draws);

/// Adds two people who walk about. A cabinet and a stool that were present while the cameras
/// learned slide to other positions, as if on casters, after people have appeared.
void drawMovedFurniture(PeopleScenario& scenario, Draws& draws);
bool movedFurniturePossible(const PeopleScenario& scenario);

} // namespace dewpoint::experiment
