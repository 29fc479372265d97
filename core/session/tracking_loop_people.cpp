// SPDX-License-Identifier: GPL-3.0-or-later
// Somebody stands somewhere, or is not there after all.
#include "core/session/tracking_loop.h"
#include "core/tracking/people/people_parameters.h"
#include "core/tracking/people/people_targets.h"
#include "core/tracking/people/person_at_pixel.h"

#include <fmt/format.h>

namespace dewpoint::session {

void TrackingLoop::changePeople(const command::ChangePeople& wish) {
  if (run_->people() == nullptr || !run_->frames()) {
    return;
  }
  if (const auto lookingAt = view_) {
    rerun(*lookingAt);
    if (rerun_) {
      rerun_->lookingAt = lookingAt;
    }
  }
  RunChange change;
  if (wish.place && peopleSettings(project_.parameters).area.contains(*wish.place)) {
    change.newPerson = middleOfBody(*wish.place, project_.parameters);
  } else if (wish.place) {
    errors_.push_back({ErrorCode::BadValue, "", "place of a person",
                       fmt::format("{:.2f}, {:.2f} m lies outside the watched floor",
                                   wish.place->x(), wish.place->y())});
  }
  change.personGone = wish.gone;
  if (wish.seen) {
    change.newPerson = personAtPixel(run_->people()->tracker(), *rig_, project_.parameters,
                                     wish.seen->camera, wish.seen->pixel);
    const auto camera = static_cast<std::size_t>(wish.seen->camera);
    if (!change.newPerson && camera < rig_->size()) {
      errors_.push_back({ErrorCode::Undetermined, "", (*rig_)[camera].name,
                         "nobody who stands on the watched floor would be seen at this pixel"});
    }
  }
  if (!change.newPerson && !change.personGone) {
    return;
  }
  run_->apply(change);
  travel_->changed(*run_, change);
  if (recordedFrame_ == head()) {
    recordFrame();
  }
}

} // namespace dewpoint::session
