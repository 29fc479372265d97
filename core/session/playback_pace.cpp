// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/playback_pace.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::session {

void PlaybackPace::set(const Pace& pace) {
  pace_ = pace;
  pace_.speed =
      std::isnan(pace.speed) ? 1.0 : std::clamp(pace.speed, Pace::kSlowest, Pace::kFastest);
}

PlaybackPace::Step PlaybackPace::next(const Situation& situation) const {
  if (situation.isAtFullSpeed) {
    return {};
  }
  const bool isSlow = pace_.slowUntilTracking && !situation.isReplaying && !situation.isHeld &&
                      situation.iterations < kMaxSlowIterations;
  if (isSlow) {
    return {situation.iterations == 0 ? kFirstIterationDelay
                                      : Seconds(1.0 / kSlowIterationsPerSecond),
            true};
  }
  return {Seconds(1.0 / (pace_.speed * std::max(1.0, situation.framesPerSecond))), false};
}

} // namespace dewpoint::session
