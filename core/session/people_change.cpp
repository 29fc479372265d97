// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/people_change.h"

#include "core/tracking/people/people_parameters.h"
#include "core/tracking/people/person_at_pixel.h"

#include <fmt/format.h>

namespace dewpoint::session {

PeopleChange peopleChange(const TrackingRun& run, const command::ChangePeople& wish,
                          std::vector<Error>& refusals) {
  const ParameterValues& parameters = run.definition()->parameters;
  PeopleChange change;
  change.personGone = wish.gone;
  if (wish.place && peopleSettings(parameters).area.contains(*wish.place)) {
    change.newPerson = middleOfBody(*wish.place, parameters);
  } else if (wish.place) {
    refusals.push_back({ErrorCode::BadValue, "", "place of a person",
                        fmt::format("{:.2f}, {:.2f} m lies outside the watched floor",
                                    wish.place->x(), wish.place->y())});
  }
  const auto* const finding = run.capability<PeopleFinding>();
  if (wish.seen && finding != nullptr) {
    change.newPerson =
        personAtPixel(*finding, run.rig(), parameters, wish.seen->camera, wish.seen->pixel);
    const auto camera = static_cast<std::size_t>(wish.seen->camera);
    if (!change.newPerson && camera < run.rig().size()) {
      refusals.push_back({ErrorCode::Undetermined, "", run.rig()[camera].name,
                          "nobody who stands on the watched floor would be seen at this pixel"});
    }
  }
  return change;
}

} // namespace dewpoint::session
