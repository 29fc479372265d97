// SPDX-License-Identifier: GPL-3.0-or-later
// Another box, or another number of targets, with methods of family Boxes.
#include "core/session/tracking_loop.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace dewpoint::session {
namespace {

/// Which of `all` is the one with this place and name among as many as `count`: with the same
/// number of them that of the same place, as one may have got another name. -1: none.
template <class Targets, class NameOf>
int counterpart(const Targets& all, const NameOf& nameOf, std::size_t count, std::size_t index,
                const std::string& name) {
  if (all.size() == count) {
    return static_cast<int>(index);
  }
  const auto found = std::ranges::find(all, name, nameOf);
  return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

/// Where those of `before` are in `after`; -1 where they are not.
std::vector<int> placesOf(const std::vector<Target>& before, const std::vector<Target>& after) {
  std::vector<int> places;
  for (std::size_t k = 0; k < before.size(); ++k) {
    places.push_back(counterpart(after, &Target::name, before.size(), k, before[k].name));
  }
  return places;
}

bool keepTheirPlaces(const std::vector<int>& places) {
  std::vector<int> same(places.size());
  std::iota(same.begin(), same.end(), 0);
  return places == same;
}

/// The first frame that is otherwise with other boxes: of each box that is new or another one, and
/// of each that a target has no more. Targets that are gone change nothing for the others.
std::optional<std::int64_t> firstChange(const std::vector<Target>& before,
                                        const std::vector<Target>& after) {
  std::optional<std::int64_t> first;
  for (std::size_t k = 0; k < after.size(); ++k) {
    const int old = counterpart(before, &Target::name, after.size(), k, after[k].name);
    const auto oldBox = old >= 0 ? before[static_cast<std::size_t>(old)].box : std::nullopt;
    if (oldBox != after[k].box) {
      const std::int64_t frame = after[k].box ? after[k].box->frame : oldBox->frame;
      first = std::min(first.value_or(frame), frame);
    }
  }
  return first;
}

} // namespace

void TrackingLoop::changeBoxes(const std::vector<Target>& targets) {
  const auto from = firstChange(run_->targets(), targets);
  const std::vector<int> places = placesOf(run_->targets(), targets);
  project_.targets = targets;
  run_->setTargets(targets);
  travel_->changed(*run_, {std::nullopt, targets, std::nullopt});
  tails_.assign(targets.size(), {});
  log_.change(project_);
  if (!keepTheirPlaces(places)) {
    log_.renumber(places, targets.size());
  }
  if ((!from && run_->frames()) || from == head()) { // a target may begin in the image shown
    frameFresh_ ? iterateFrame() : recordFrame();
  } else if (from && *from < head()) {
    rerun(*from);
  } else if (from && view_ == from) { // in a part that was not tracked yet
    const PlayState state = state_;
    rerun(*from);
    if (frameFresh_) {
      iterateFrame();
      state_ = state_ == PlayState::Playing ? state : state_;
    }
  }
}

void TrackingLoop::showPresentBoxes(TrackSnapshot& snapshot) const {
  if (run_->family() != MethodFamily::Boxes) {
    return;
  }
  const std::vector<TargetSnapshot> before = std::exchange(snapshot.targets, {});
  const auto nameOf = [](const TargetSnapshot& shown) { return shown.target.name; };
  const std::vector<Target>& targets = run_->targets();
  for (std::size_t k = 0; k < targets.size(); ++k) {
    const int old = counterpart(before, nameOf, targets.size(), k, targets[k].name);
    TargetSnapshot& shown = snapshot.targets.emplace_back();
    if (old >= 0) {
      shown = before[static_cast<std::size_t>(old)];
    } else { // it was added later
      shown.estimate.gone = true;
      shown.status = TargetStatus::Gone;
    }
    shown.target = targets[k];
  }
}

} // namespace dewpoint::session
