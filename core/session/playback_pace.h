// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <chrono>
#include <cstdint>

namespace dewpoint::session {

/// How fast a person wants a recording to be played.
struct Pace {
  double speed = 1.0; ///< frames of the recording per frame in real time; see kSlowest, kFastest
  /// Iteration by iteration until every target is held, so that one sees the particles converge.
  bool slowUntilHeld = false;

  static constexpr double kSlowest = 1.0 / 30.0;
  static constexpr double kFastest = 8.0;

  bool operator==(const Pace&) const = default;
};

/// Decides when a session that plays does its next step, and how large that is. Never what is
/// computed: a run gives the same bits at any pace.
class PlaybackPace {
public:
  using Seconds = std::chrono::duration<double>;

  // Judgments: what an eye can follow, and how long a person wants to wait for it.

  /// Iterations per second while they are played one by one.
  static constexpr double kSlowIterations = 5.0;
  /// How long the particles are shown as they are before the first iteration.
  static constexpr Seconds kBeforeFirst{1.5};
  /// After so many iterations of a run (five seconds) it plays on even if a target is not held: it
  /// may not be there yet.
  static constexpr std::int64_t kMostSlowIterations = 25;

  /// Where the session stands.
  struct Situation {
    double framesPerSecond = 30.0;
    /// New images of live cameras are awaited, or past frames are tracked again: as fast as it
    /// goes.
    bool isHurried = false;
    bool isReplaying = false;    ///< shows what was tracked already
    std::int64_t iterations = 0; ///< of this run
    bool isHeld = false;         ///< every target is
  };
  struct Step {
    Seconds period{};         ///< from the step before
    bool isIteration = false; ///< one iteration; else a frame with all of its iterations

    bool operator==(const Step&) const = default;
  };

  /// Speeds beyond the slowest and fastest are cut to them; a speed that is no number is 1.
  void set(const Pace& pace);
  const Pace& pace() const { return pace_; }
  Step next(const Situation& situation) const;

private:
  Pace pace_;
};

} // namespace dewpoint::session
