// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/people/people_tracker.h"

#include "core/tracking/people/mohedano_tracker.h"
#include "core/tracking/people/people_parameters.h"
#include "core/tracking/people/people_particle_tracker.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace dewpoint::tracking {

std::string personName(int identity) {
  return fmt::format("person {}", identity);
}

std::optional<int> personIdentity(std::string_view name) {
  constexpr std::string_view kPerson = "person ";
  int identity = 0;
  if (!name.starts_with(kPerson)) {
    return std::nullopt;
  }
  const char* const end = name.data() + name.size();
  const auto read = std::from_chars(name.data() + kPerson.size(), end, identity);
  const bool whole = read.ec == std::errc() && read.ptr == end;
  return whole && identity > 0 ? std::optional(identity) : std::nullopt;
}

std::vector<std::string> peopleMethodNames() {
  return {"people", "mohedano-msc", "mohedano-ms"};
}

std::string_view peopleMethodSentence(std::string_view method) {
  if (method == "people") {
    return "Several people who walk, meet and wear similar clothes: places on the floor, told "
           "apart "
           "by what each of them covers in the images.";
  }
  if (method == "mohedano-msc") {
    return "Several people by motion and color, each by a filter of its own (Mohedano et al. 2009, "
           "MS+C): keeps them apart when their clothes differ.";
  }
  if (method == "mohedano-ms") {
    return "Several people by motion only (Mohedano et al. 2009, MS): covers whole bodies, but "
           "confuses people who come close.";
  }
  return "";
}

std::span<const ParameterDeclaration> peopleMethodParameters(std::string_view method) {
  if (method == "people") {
    return peopleParameters();
  }
  if (method == "mohedano-msc") {
    return mohedanoMscParameters();
  }
  if (method == "mohedano-ms") {
    return mohedanoMsParameters();
  }
  return {};
}

Result<std::unique_ptr<PeopleTracker>> makePeopleTracker(const std::string& method,
                                                         const ParameterValues& parameters,
                                                         const CameraRig& rig) {
  const auto declared = parameters.declarations();
  for (const ParameterDeclaration& needed : peopleMethodParameters(method)) {
    if (std::ranges::find(declared, needed.key, &ParameterDeclaration::key) == declared.end()) {
      return failure(ErrorCode::MissingKey, "", needed.key,
                     fmt::format("method {} needs it", method));
    }
  }
  if (method == "people") {
    return std::make_unique<PeopleParticleTracker>(parameters, rig);
  }
  if (method == "mohedano-msc" || method == "mohedano-ms") {
    return std::make_unique<MohedanoTracker>(parameters, rig, method == "mohedano-msc");
  }
  return failure(ErrorCode::NotFound, "", "method",
                 fmt::format("{}: known are {}", method, fmt::join(peopleMethodNames(), ", ")));
}

} // namespace dewpoint::tracking
