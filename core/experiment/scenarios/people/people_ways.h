// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/people/people_scenario.h"
#include "core/experiment/scenarios/random_draws.h"

#include <Eigen/Core>

namespace dewpoint::experiment {

/// Time at which people appear, seconds. By then, the cameras have learned the background.
inline constexpr double kAppearTime = 1.3;

/// Range from which a distance between two people is drawn, meters.
struct GapRange {
  double low = 0.0;
  double high = 0.0;
};

/// Returns the unit vector on the floor (world x and y) in a direction. `angle` is measured from x
/// toward y, in radians.
Eigen::Vector2d headingVector(double angle);

/// Returns whether a person can stand at `position` (world x and y, meters), outside the furniture
/// and away from the walls.
bool isWalkable(const Eigen::Vector2d& position);
/// Returns whether a person can stand at every waypoint of the walker.
bool isPathFree(const simulation::Walker& walker);

/// Creates the walker "person N", who is present from kAppearTime on.
simulation::Walker makeNumberedWalker(int number);

// Each of the following functions adds people with their paths, and sets the times at which
// identities are assessed.

/// Adds two people who walk past each other. They are closest, at a distance within `gapRange`,
/// when both are halfway.
void addCrossingPeople(PeopleScenario& scenario, const GapRange& gapRange, RandomDraws& draws);
/// Adds two people who approach each other up to a distance within `gapRange`, stand there, and
/// walk back.
void addMeetingPeople(PeopleScenario& scenario, const GapRange& gapRange, RandomDraws& draws);
/// Adds two people who meet, walk side by side, and separate.
void addAccompanyingPeople(PeopleScenario& scenario, RandomDraws& draws);
/// Adds two people who stay far from each other.
void addDistantPeople(PeopleScenario& scenario, RandomDraws& draws);
/// Adds three people who enter through doors one after another and leave through other doors.
void addVisitors(PeopleScenario& scenario, RandomDraws& draws);

} // namespace dewpoint::experiment
