// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/people/people_scenario.h"
#include "core/experiment/scenarios/random_draws.h"

namespace dewpoint::experiment {

// What people do beyond the paper's scenes. draw... adds people with their ways and sets when
// identities are assessed; ...Possible says whether they could have walked so; give... and take...
// change a scene whose people are dressed.

/// Three who walk about, not near each other.
void drawStrolls(PeopleScenario& scenario, Draws& draws);
bool strollsPossible(const PeopleScenario& scenario);
/// Heights for them: a child of 0.9 to 1.3 m, somebody of 1.3 to 1.6 m, somebody of 1.88 to 2 m.
void giveHeights(PeopleScenario& scenario, PeopleClothes clothes, Draws& draws);

/// One who sits down on a stool and rises, one who crouches, and one who walks by.
void drawSitting(PeopleScenario& scenario, Draws& draws);
bool sittingPossible(const PeopleScenario& scenario);
/// The stool: as high as fits the person, there from the beginning.
void giveStool(PeopleScenario& scenario, PeopleClothes clothes, Draws& draws);

/// A box for the first and a bag for the second.
void giveLoads(PeopleScenario& scenario, PeopleClothes clothes, Draws& draws);

/// Five to eight who mill about for 12 s; their ways may touch and cross.
void drawCrowd(PeopleScenario& scenario, Draws& draws);
bool crowdPossible(const PeopleScenario& scenario);
/// Heights of 1.5 to 2 m.
void giveCrowdHeights(PeopleScenario& scenario, PeopleClothes clothes, Draws& draws);

/// Leaves two of the cameras, neighbors or opposite ones.
void takeCameras(PeopleScenario& scenario, PeopleClothes clothes, Draws& draws);

/// Two who walk about; a cabinet and a stool that were there while the cameras learned glide to
/// other positions, as on rollers, after people have appeared.
void drawMovedFurniture(PeopleScenario& scenario, Draws& draws);
bool movedFurniturePossible(const PeopleScenario& scenario);

} // namespace dewpoint::experiment
