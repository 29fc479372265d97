// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/rewind/change_rule.h"

namespace dewpoint::session {

double ChangeRule::expectedSeconds(const OldResults& old) {
  // What comes after an old result was tracked on from it.
  return old.frameRanges.empty()
             ? 0.0
             : static_cast<double>(old.newestFrame - old.frameRanges.front().firstFrame + 1) *
                   old.secondsPerFrame;
}

ChangeRule::Decision ChangeRule::decideOn(const SessionState& state) {
  const OldResults& old = state.oldResults;
  if (state.isLive || old.frameRanges.empty()) {
    return {};
  }
  const std::int64_t from = old.frameRanges.front().firstFrame;
  if (state.isPlaying && !state.isRerunning) {
    return {Action::Mark, from};
  }
  if (state.settingsChanged) {
    return {expectedSeconds(old) < state.quickRerunLimitSeconds ? Action::TrackAgain
                                                                : Action::Offer,
            from};
  }
  // A rerun under way may be what makes them new.
  return {state.isRerunning ? Action::Mark : Action::Offer, from};
}

} // namespace dewpoint::session
