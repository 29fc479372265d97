// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/people/people_scenario.h"
#include "core/experiment/scenarios/random_draws.h"

#include <vector>

namespace dewpoint::experiment {

/// Draws heights of 1.62 to 1.88 m and plain clothes for all people.
void dress(std::vector<simulation::Walker>& people, PeopleClothes clothes, RandomDraws& draws);

/// Chooses random clothes for the people, in the colors of the office (walls, floor, wood and
/// partition). With PeopleClothes::Similar, all people wear the same clothes.
void dressLikeTheRoom(PeopleScenario& scenario, PeopleClothes clothes, RandomDraws& draws);

/// Draws a two-color pattern for each shirt. With PeopleClothes::Similar, all shirts have the same
/// pattern.
void dressInPatterns(PeopleScenario& scenario, PeopleClothes clothes, RandomDraws& draws);

} // namespace dewpoint::experiment
