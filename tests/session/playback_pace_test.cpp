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
  const auto step = pace.nextStep({.framesPerSecond = 25.0});
  EXPECT_DOUBLE_EQ(step.period.count(), 0.04);
  EXPECT_FALSE(step.isIteration);
}

TEST(PlaybackPace, IsSlowerAndFasterWithinLimits) {
  PlaybackPace pace;
  for (const auto& [wanted, speed] :
       {std::pair{0.5, 0.5}, {8.0, 8.0}, {100.0, 8.0}, {0.0, 1.0 / 30.0}, {-1.0, 1.0 / 30.0}}) {
    pace.setPace({.speedFactor = wanted});
    EXPECT_DOUBLE_EQ(pace.nextStep({.framesPerSecond = 30.0}).period.count(), 1.0 / (30.0 * speed));
  }
  pace.setPace({.speedFactor = std::numeric_limits<double>::quiet_NaN()});
  EXPECT_DOUBLE_EQ(pace.pace().speedFactor, 1.0);
}

TEST(PlaybackPace, DoesNotHoldUpLiveCamerasAndWhatIsTrackedAgain) {
  PlaybackPace pace;
  pace.setPace({.speedFactor = 0.1, .slowUntilTracking = true});
  EXPECT_EQ(pace.nextStep({.isAtFullSpeed = true}), PlaybackPace::Step());
}

TEST(PlaybackPace, ShowsTheFirstIterationsOneByOne) {
  PlaybackPace pace;
  pace.setPace({.speedFactor = 8.0, .slowUntilTracking = true});
  EXPECT_EQ(pace.nextStep({.iterationCount = 0}),
            (PlaybackPace::Step{PlaybackPace::kFirstIterationDelay, true}));
  EXPECT_EQ(pace.nextStep({.iterationCount = 1}),
            (PlaybackPace::Step{Seconds(1.0 / PlaybackPace::kSlowIterationsPerSecond), true}));
}

TEST(PlaybackPace, GoesOnAtItsSpeedOnceEveryTargetIsHeld) {
  PlaybackPace pace;
  pace.setPace({.slowUntilTracking = true});
  const Situation held{.framesPerSecond = 10.0, .iterationCount = 7, .isEveryTargetHeld = true};
  EXPECT_EQ(pace.nextStep(held), (PlaybackPace::Step{Seconds(0.1), false}));
}

TEST(PlaybackPace, DoesNotWaitForEverForATargetThatIsNotThere) {
  PlaybackPace pace;
  pace.setPace({.slowUntilTracking = true});
  const Situation lost{.framesPerSecond = 10.0, .iterationCount = PlaybackPace::kMaxSlowIterations};
  EXPECT_FALSE(pace.nextStep(lost).isIteration);
}

TEST(PlaybackPace, ReplaysWhatWasTrackedFrameByFrame) {
  PlaybackPace pace;
  pace.setPace({.slowUntilTracking = true});
  EXPECT_FALSE(pace.nextStep({.isReplaying = true, .iterationCount = 3}).isIteration);
}

} // namespace
} // namespace dewpoint::tests
