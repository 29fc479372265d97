// SPDX-License-Identifier: GPL-3.0-or-later
// Another box, or another number of targets, with methods of family Boxes.
#include "core/session/tracking_loop.h"

#include <algorithm>

namespace dewpoint {
namespace {

const Target* counterpart(const std::vector<Target>& targets, bool byIndex, std::size_t index,
                          const std::string& name) {
  if (byIndex) {
    return &targets[index];
  }
  const auto found = std::ranges::find(targets, name, &Target::name);
  return found == targets.end() ? nullptr : &*found;
}

/// The first frame that is otherwise with other boxes: of each box that is new or another one, and
/// of each that a target has no more. Targets that are gone change nothing for the others.
std::optional<std::int64_t> firstChange(const std::vector<Target>& before,
                                        const std::vector<Target>& after) {
  std::optional<std::int64_t> first;
  for (std::size_t k = 0; k < after.size(); ++k) {
    const Target* old = counterpart(before, before.size() == after.size(), k, after[k].name);
    const auto oldBox = old != nullptr ? old->box : std::nullopt;
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
  project_.targets = targets;
  run_->setTargets(targets);
  travel_->changed(*run_, {std::nullopt, targets, std::nullopt});
  tails_.assign(targets.size(), {});
  log_.change(project_);
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

} // namespace dewpoint
