// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/people/people_scenario.h"
#include "core/experiment/scenarios/random_draws.h"

#include <Eigen/Core>

namespace dewpoint::experiment {

/// Seconds at which people appear: the cameras have learned the background by then.
inline constexpr double kAppear = 1.3;

/// The range from which a distance between two people is drawn, meters.
struct Gap {
  double least = 0.0;
  double most = 0.0;
};

/// Unit vector on the floor; `angle` in radians from world x to y.
Eigen::Vector2d headingVector(double angle);

/// Whether somebody can stand here: not in the furniture, nor along the walls. World x and y,
/// meters.
bool isWalkable(const Eigen::Vector2d& position);
/// Whether this holds for all waypoints.
bool isWalkable(const simulation::Walker& walker);

/// "person N", who is there from kAppear on.
simulation::Walker numberedWalker(int number);

// Each of these adds people with their ways, and sets when identities are assessed.

/// Two who walk past each other: nearest, by a distance of `gapRange`, when both are in the middle.
void crossWays(PeopleScenario& scenario, const Gap& gapRange, Draws& draws);
/// Two who come as near each other as `gapRange` says, stand there, and go back.
void meetWays(PeopleScenario& scenario, const Gap& gapRange, Draws& draws);
/// Two who come together, walk side by side, and part.
void accompanyWays(PeopleScenario& scenario, Draws& draws);
/// Two who stay far from each other.
void apartWays(PeopleScenario& scenario, Draws& draws);
/// Three who come through doors, one after the other, and leave by others.
void visitWays(PeopleScenario& scenario, Draws& draws);

} // namespace dewpoint::experiment
