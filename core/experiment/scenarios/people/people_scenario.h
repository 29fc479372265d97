// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/simulation/people/office.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Whether people can be distinguished by their clothes.
enum class PeopleClothes { Different, Similar };

/// People in the simulated office, drawn from a seed.
struct PeopleScenario {
  OfficeScene scene;
  /// Instants between which identities are to be kept, seconds: before and after people meet.
  double before = 0.0;
  double after = 0.0;
};

/// Those of Mohedano et al. 2009: "crossing", "meet-and-turn", "side-by-side", "enter-leave", and
/// "apart", the easy case; then what people also do: "heights", "sitting", "carrying", "crowd",
/// "two-cameras", "contact", "furniture-moved", "room-clothes" and "patterned-clothes".
const std::vector<std::string>& peopleScenarioNames();
/// What happens in it, one sentence.
std::string peopleScenarioSentence(const std::string& name);
/// Whether it is a scene of Mohedano et al. 2009.
bool isPeopleScenarioOfPaper(const std::string& name);
/// NotFound for an unknown name; Undetermined when the seed draws no ways that are possible.
Result<PeopleScenario> makePeopleScenario(const std::string& name, PeopleClothes clothes,
                                          std::uint64_t seed);

} // namespace dewpoint::experiment
