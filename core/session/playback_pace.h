// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <chrono>
#include <cstdint>

namespace dewpoint::session {

/// Playing speed of a recording, chosen by the user.
struct Pace {
  double speedFactor = 1.0; ///< factor relative to real time, between kSlowest and kFastest
  /// If true, iterations are shown one by one until the cameras confirm every target ///
  /// (isConfirmed()), so that the user sees the filters converge.
  bool slowUntilTracking = false;

  static constexpr double kSlowest = 1.0 / 30.0;
  static constexpr double kFastest = 8.0;

  bool operator==(const Pace&) const = default;
};

/// Decides when a playing session takes its next step, and how large the step is. The results are
/// bit-identical at any pace.
class PlaybackPace {
public:
  using Seconds = std::chrono::duration<double>;

  // These values are based on what the eye can follow and how long a user is willing to wait.

  /// Iterations per second while they are shown one by one.
  static constexpr double kSlowIterationsPerSecond = 5.0;
  /// Time in seconds during which the initial particles are shown before the first iteration.
  static constexpr Seconds kFirstIterationDelay{1.5};
  /// Number of iterations after which a run plays at normal speed even if a target is not held
  /// (confirmed by the cameras): the target may not be in the scene yet.
  static constexpr std::int64_t kMaxSlowIterations = 25;

  /// State of the session that determines the next step.
  struct Situation {
    double framesPerSecond = 30.0;
    /// True if the session takes its steps as fast as possible, because the cameras are live or
    /// past frames are being tracked again.
    bool isAtFullSpeed = false;
    bool isReplaying = false;        ///< shows frames that were already tracked
    std::int64_t iterationCount = 0; ///< number of iterations in the current run
    bool isEveryTargetHeld = false;  ///< the cameras confirm every target
  };
  struct Step {
    Seconds period{};         ///< time from the previous step to this one
    bool isIteration = false; ///< true: one iteration; false: a frame with all its iterations

    bool operator==(const Step&) const = default;
  };

  /// Sets the pace. A speed outside kSlowest to kFastest is limited to this range; NaN becomes 1.
  void setPace(const Pace& pace);
  const Pace& pace() const { return pace_; }
  /// Returns the next step: when it is due, and how large it is.
  Step nextStep(const Situation& situation) const;

private:
  Pace pace_;
};

} // namespace dewpoint::session
