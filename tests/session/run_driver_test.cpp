// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run_driver.h"
#include "tests/session/drawn_recording.h"

#include <gtest/gtest.h>

#include <utility>

namespace dewpoint::tests {
namespace {

using test::drawnInputs;
using test::sameBits;

constexpr std::int64_t kDrivenFrames = 12;

/// Two frames to track again from, the second one asked for before anything was tracked.
class ADriverThatGoesBackTwice : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(ADriverThatGoesBackTwice, LosesNoFrame) {
  FrameTapSlot tap;
  RunLog log;
  const TruthTable truth{Trajectory()};
  RunDriver driver(drawnInputs("dewpoint", 2 * kDrivenFrames), tap, log, truth);
  driver.start();
  for (std::int64_t frame = 0; frame < kDrivenFrames; ++frame) {
    driver.stepFrame();
  }
  const Trajectory first = log.trajectory();
  ASSERT_EQ(first.samples.size(), std::size_t{kDrivenFrames});
  driver.rerun(GetParam().first);
  driver.rerun(GetParam().second);
  for (std::int64_t frame = 0; frame < kDrivenFrames && driver.playback().rerunRange(); ++frame) {
    driver.advance();
  }
  EXPECT_FALSE(driver.playback().rerunRange());
  EXPECT_TRUE(sameBits(log.trajectory(), first));
}

INSTANTIATE_TEST_SUITE_P(Orders, ADriverThatGoesBackTwice,
                         testing::Values(std::pair(8, 4), std::pair(4, 8), std::pair(4, 4)));

/// A run of several iterations per frame over all frames of its input; its trajectory.
Trajectory trackAll(bool iterationByIteration) {
  FrameTapSlot tap;
  RunLog log;
  const TruthTable truth{Trajectory()};
  SessionInputs inputs = drawnInputs("barrera", kDrivenFrames);
  inputs.project.parameters.set("iterations_per_frame", 5);
  RunDriver driver(std::move(inputs), tap, log, truth);
  driver.start();
  driver.play();
  int steps = 0;
  for (; driver.playback().isRunning() && steps < 1000; ++steps) {
    // Also a frame that was begun one by one and is finished at once.
    driver.advance(iterationByIteration && steps != 7);
  }
  EXPECT_EQ(steps > 2 * kDrivenFrames, iterationByIteration);
  return log.trajectory();
}

TEST(RunDriver, TracksTheSameIterationByIteration) {
  const Trajectory whole = trackAll(false);
  ASSERT_EQ(whole.samples.size(), std::size_t{kDrivenFrames});
  EXPECT_TRUE(sameBits(trackAll(true), whole));
}

} // namespace
} // namespace dewpoint::tests
