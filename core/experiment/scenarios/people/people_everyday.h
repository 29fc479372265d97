// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/people/people_scenario.h"
#include "core/experiment/scenarios/random_draws.h"

namespace dewpoint::experiment {

// Scenes of people that are not from the paper. Functions named add... without a parameter
// `clothes` add people with their paths, and set the times at which identities are assessed.
// Functions named is...Possible report whether people could walk these paths. Functions with a
// parameter `clothes` change a scene whose people are already dressed.

/// Adds three people who walk around and stay away from each other.
void addStrollingPeople(PeopleScenario& scenario, RandomDraws& draws);
bool isStrollPossible(const PeopleScenario& scenario);
/// Sets the heights of the strolling people: a child of 0.9 to 1.3 m, a person of 1.3 to 1.6 m, and
/// a person of 1.88 to 2 m. `clothes` has no effect.
void setVariedHeights(PeopleScenario& scenario, PeopleClothes clothes, RandomDraws& draws);

/// Adds one person who sits down on a stool and stands up, one who crouches, and one who walks
/// past.
void addSittingPeople(PeopleScenario& scenario, RandomDraws& draws);
bool isSittingPossible(const PeopleScenario& scenario);
/// Adds a stool for the person who sits down, with a height that suits this person. The stool is
/// present from the beginning. `clothes` and `draws` have no effect.
void addStool(PeopleScenario& scenario, PeopleClothes clothes, RandomDraws& draws);

/// Gives the first person a box to carry, and the second person a bag. `clothes` has no effect.
void addCarriedObjects(PeopleScenario& scenario, PeopleClothes clothes, RandomDraws& draws);

/// Adds five to eight people who walk around for 12 s. Their paths may touch and cross.
void addCrowd(PeopleScenario& scenario, RandomDraws& draws);
bool isCrowdPossible(const PeopleScenario& scenario);
/// Sets heights of 1.5 to 2 m for the people in the crowd. `clothes` has no effect.
void setCrowdHeights(PeopleScenario& scenario, PeopleClothes clothes, RandomDraws& draws);

/// Removes all cameras except two, which are either neighbors or opposite each other. `clothes` has
/// no effect.
void keepTwoCameras(PeopleScenario& scenario, PeopleClothes clothes, RandomDraws& draws);

/// Adds two people who walk around, a cabinet and a stool. The cameras learn the background with
/// the furniture in its initial position. After the people have appeared, the furniture slides to
/// other positions, as if on casters.
void addPeopleAndMovedFurniture(PeopleScenario& scenario, RandomDraws& draws);
bool isMovedFurniturePossible(const PeopleScenario& scenario);

} // namespace dewpoint::experiment
