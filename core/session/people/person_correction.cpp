// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/people/person_correction.h"

#include "core/tracking/people/people_parameters.h"
#include "core/tracking/people/person_at_pixel.h"

#include <fmt/format.h>

#include <algorithm>

namespace dewpoint::session {
namespace {

/// A person who is said not to be there stands at most so far from the place, meters: less than
/// two people do from each other.
constexpr double kReach = 0.3;

std::optional<int> personNear(const PeopleFinding& finding, const Eigen::Vector2d& position) {
  const auto distance = [&](const PersonEstimate& person) {
    return (person.position.head<2>() - position).norm();
  };
  const auto& people = finding.people();
  const auto nearest = std::ranges::min_element(people, {}, distance);
  return nearest != people.end() && distance(*nearest) <= kReach ? std::optional(nearest->identity)
                                                                 : std::nullopt;
}

} // namespace

PeopleChange peopleChange(const PersonCorrection& correction, const PeopleFinding& finding,
                          const CameraRig& rig, const ParameterValues& parameters,
                          std::vector<Error>& correctionErrors) {
  PeopleChange change;
  if (correction.position && !correction.isPresent) {
    change.removedPersonId = personNear(finding, *correction.position);
  } else if (correction.position &&
             peopleSettings(parameters).area.contains(*correction.position)) {
    change.newPersonPosition = bodyCenter(*correction.position, parameters);
  } else if (correction.position) {
    correctionErrors.push_back({ErrorCode::BadValue, "", "place of a person",
                                fmt::format("{:.2f}, {:.2f} m lies outside the tracked floor",
                                            correction.position->x(), correction.position->y())});
  }
  if (correction.click) {
    const auto camera = static_cast<std::size_t>(correction.click->camera);
    change.newPersonPosition = personCenterAtPixel(
        finding, rig, parameters, correction.click->camera, correction.click->pixel);
    if (!change.newPersonPosition && camera < rig.size()) {
      correctionErrors.push_back({ErrorCode::Undetermined, "", rig[camera].name,
                                  "a person on the tracked floor cannot appear at this pixel"});
    }
  }
  return change;
}

} // namespace dewpoint::session
