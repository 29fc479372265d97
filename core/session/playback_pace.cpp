// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/playback_pace.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::session {

void PlaybackPace::setPace(const Pace& pace) {
  pace_ = pace;
  pace_.speedFactor = std::isnan(pace.speedFactor)
                          ? 1.0
                          : std::clamp(pace.speedFactor, Pace::kSlowest, Pace::kFastest);
}

PlaybackPace::Step PlaybackPace::nextStep(const Situation& situation) const {
  if (situation.isAtFullSpeed) {
    return {};
  }
  const bool isSlow = pace_.slowUntilTracking && !situation.isReplaying &&
                      !situation.isEveryTargetHeld && situation.iterationCount < kMaxSlowIterations;
  if (isSlow) {
    return {situation.iterationCount == 0 ? kFirstIterationDelay
                                          : Seconds(1.0 / kSlowIterationsPerSecond),
            true};
  }
  return {Seconds(1.0 / (pace_.speedFactor * std::max(1.0, situation.framesPerSecond))), false};
}

} // namespace dewpoint::session
