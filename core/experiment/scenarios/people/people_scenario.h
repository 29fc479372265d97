// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/simulation/people/office.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Clothes of the people: distinguishable, or similar to each other.
enum class PeopleClothes { Different, Similar };

/// People in the simulated office, drawn from a seed.
struct PeopleScenario {
  OfficeScene scene;
  /// Instant before the people meet, in seconds from the start; 0 if identities are not compared in
  /// this scenario. The identities at the instant `timeAfterMeeting` must be the same as at this
  /// instant.
  double timeBeforeMeeting = 0.0;
  double timeAfterMeeting = 0.0; ///< instant after the people have met, in seconds from the start
};

/// Returns the names of all scenarios with people. The scenarios of Mohedano et al. 2009 come
/// first: "crossing", "meet-and-turn", "side-by-side", "enter-leave", and the easy case "apart".
/// Then come everyday scenes: "heights", "sitting", "carrying", "crowd", "two-cameras", "contact",
/// "furniture-moved", "room-clothes" and "patterned-clothes".
const std::vector<std::string>& peopleScenarioNames();
/// Describes what happens in a scenario, in one sentence.
std::string peopleScenarioDescription(const std::string& name);
/// Returns whether a scenario is from Mohedano et al. 2009.
bool isPeopleScenarioOfPaper(const std::string& name);
/// Creates a scenario with people from a seed. Returns NotFound for an unknown name, and
/// Undetermined if the seed yields no possible paths.
Result<PeopleScenario> makePeopleScenario(const std::string& name, PeopleClothes clothes,
                                          std::uint64_t seed);

} // namespace dewpoint::experiment
