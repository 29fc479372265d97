// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/playback_pace.h"

#include <gtest/gtest.h>

#include <limits>

namespace dewpoint::tests {
namespace {

using Situation = PlaybackPace::Situation;
using Seconds = PlaybackPace::Seconds;

TEST(PlaybackPace, PlaysARecordingAsFastAsItWasFilmed) {
  const PlaybackPace pace;
  const auto step = pace.next({.framesPerSecond = 25.0});
  EXPECT_DOUBLE_EQ(step.period.count(), 0.04);
  EXPECT_FALSE(step.isIteration);
}

TEST(PlaybackPace, IsSlowerAndFasterWithinLimits) {
  PlaybackPace pace;
  for (const auto& [wanted, speed] :
       {std::pair{0.5, 0.5}, {8.0, 8.0}, {100.0, 8.0}, {0.0, 1.0 / 30.0}, {-1.0, 1.0 / 30.0}}) {
    pace.set({.speed = wanted});
    EXPECT_DOUBLE_EQ(pace.next({.framesPerSecond = 30.0}).period.count(), 1.0 / (30.0 * speed));
  }
  pace.set({.speed = std::numeric_limits<double>::quiet_NaN()});
  EXPECT_DOUBLE_EQ(pace.pace().speed, 1.0);
}

TEST(PlaybackPace, DoesNotHoldUpLiveCamerasAndWhatIsTrackedAgain) {
  PlaybackPace pace;
  pace.set({.speed = 0.1, .slowUntilTracking = true});
  EXPECT_EQ(pace.next({.isAtFullSpeed = true}), PlaybackPace::Step());
}

TEST(PlaybackPace, ShowsTheFirstIterationsOneByOne) {
  PlaybackPace pace;
  pace.set({.speed = 8.0, .slowUntilTracking = true});
  EXPECT_EQ(pace.next({.iterations = 0}),
            (PlaybackPace::Step{PlaybackPace::kFirstIterationDelay, true}));
  EXPECT_EQ(pace.next({.iterations = 1}),
            (PlaybackPace::Step{Seconds(1.0 / PlaybackPace::kSlowIterationsPerSecond), true}));
}

TEST(PlaybackPace, GoesOnAtItsSpeedOnceEveryTargetIsHeld) {
  PlaybackPace pace;
  pace.set({.slowUntilTracking = true});
  const Situation held{.framesPerSecond = 10.0, .iterations = 7, .isHeld = true};
  EXPECT_EQ(pace.next(held), (PlaybackPace::Step{Seconds(0.1), false}));
}

TEST(PlaybackPace, DoesNotWaitForEverForATargetThatIsNotThere) {
  PlaybackPace pace;
  pace.set({.slowUntilTracking = true});
  const Situation lost{.framesPerSecond = 10.0, .iterations = PlaybackPace::kMaxSlowIterations};
  EXPECT_FALSE(pace.next(lost).isIteration);
}

TEST(PlaybackPace, ReplaysWhatWasTrackedFrameByFrame) {
  PlaybackPace pace;
  pace.set({.slowUntilTracking = true});
  EXPECT_FALSE(pace.next({.isReplaying = true, .iterations = 3}).isIteration);
}

} // namespace
} // namespace dewpoint::tests
