// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/people/people_scenario.h"
#include "core/experiment/scenarios/random_draws.h"

#include <Eigen/Core>

namespace dewpoint::experiment {

/// Time at which people appear, seconds. The cameras have learned the background by then.
inline constexpr double kAppear = 1.3;

/// Range from which a distance between two people is drawn, meters.
struct Gap {
  double least = 0.0;
  double most = 0.0;
};

/// Unit vector on the floor; `angle` in radians from world x to y.
Eigen::Vector2d headingVector(double angle);

/// Whether a person can stand here: not in the furniture, nor close to the walls. World x and y,
/// meters.
bool isWalkable(const Eigen::Vector2d& position);
/// Whether a person can stand at all waypoints.
bool isWalkable(const simulation::Walker& walker);

/// Makes "person N", who is present from kAppear on.
simulation::Walker numberedWalker(int number);

// Each of these adds people with their paths, and sets when identities are assessed.

/// Two people who walk past each other. They are nearest, at a distance within `gapRange`, when
/// both are halfway.
void crossWays(PeopleScenario& scenario, const Gap& gapRange, Draws& draws);
/// Two people who approach each other up to a distance within `gapRange`, stand there, and go back.
void meetWays(PeopleScenario& scenario, const Gap& gapRange, Draws& draws);
/// Two people who meet, walk side by side, and part.
void accompanyWays(PeopleScenario& scenario, Draws& draws);
/// Two people who stay far from each other.
void apartWays(PeopleScenario& scenario, Draws& draws);
/// Three people who enter through doors, one after the other, and leave through others.
void visitWays(PeopleScenario& scenario, Draws& draws);

} // namespace dewpoint::experiment
