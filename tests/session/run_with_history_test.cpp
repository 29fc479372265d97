// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run/frame_loop.h"
#include "core/session/run_with_history.h"
#include "tests/session/drawn_recording.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace dewpoint::tests {
namespace {

using test::drawnInputs;

constexpr std::int64_t kRememberedFrames = 15;

class ARememberedRun : public testing::Test {
protected:
  void SetUp() override {
    ASSERT_TRUE(runWithHistory_.startNewRun(*runWithHistory_.definition(), 0));
    runWithHistory_.keepHistory(*inputs_.source, std::size_t{64} << 20);
  }

  /// Tracks a frame; what is believed of the target then.
  TrajectorySample track(const FrameSetPtr& frames) {
    runWithHistory_.beginFrame(frames);
    runWithHistory_.applyLaterChanges();
    EXPECT_TRUE(trackOneFrame(runWithHistory_.run(), {}));
    runWithHistory_.record();
    return runWithHistory_.run().samples().at(0);
  }
  void growTarget() {
    RunDefinition larger = *runWithHistory_.definition();
    larger.targets[0].radius *= 1.2;
    EXPECT_TRUE(runWithHistory_.change(std::move(larger)));
  }

  SessionInputs inputs_ = drawnInputs("dewpoint", kRememberedFrames);
  RunWithHistory runWithHistory_{RunDefinition::fromProject(inputs_.project), 1};
};

TEST_F(ARememberedRun, GoesOnFromAnEarlierFrameWithTheSameBits) {
  std::vector<TrajectorySample> first;
  for (std::int64_t k = 0; k < kRememberedFrames; ++k) {
    if (k == 5) {
      growTarget(); // a change that must be made again on the way back
    }
    const auto frames = inputs_.source->next();
    ASSERT_TRUE(frames);
    first.push_back(track(*frames));
  }
  EXPECT_EQ(runWithHistory_.headFrame(), kRememberedFrames - 1);
  runWithHistory_.setThreadCount(3);
  ASSERT_TRUE(runWithHistory_.timeTravel().goBack(runWithHistory_.run(), 8, [] { return true; }));
  runWithHistory_.timeTravel().forgetFrom(8);
  for (std::int64_t k = 8; k < kRememberedFrames; ++k) {
    const auto frames = runWithHistory_.timeTravel().framesAt(k);
    ASSERT_TRUE(frames);
    const TrajectorySample again = track(*frames);
    const TrajectorySample& before = first[static_cast<std::size_t>(k)];
    EXPECT_EQ(again.frame, k);
    EXPECT_EQ(again.position, before.position) << k;
    EXPECT_EQ(again.covariance, before.covariance) << k;
  }
}

TEST_F(ARememberedRun, CatchesUpWithWhatChangedSinceTheFrameItGoesBackTo) {
  for (std::int64_t k = 0; k < kRememberedFrames; ++k) {
    const auto frames = inputs_.source->next();
    ASSERT_TRUE(frames);
    track(*frames);
  }
  const double radius = runWithHistory_.definition()->targets[0].radius;
  growTarget();
  ASSERT_TRUE(runWithHistory_.timeTravel().goBack(runWithHistory_.run(), 8, [] { return true; }));
  EXPECT_EQ(runWithHistory_.run().definition()->targets[0].radius, radius); // as it was then
  EXPECT_GT(runWithHistory_.definition()->targets[0].radius, radius);
  runWithHistory_.timeTravel().forgetFrom(8);
  track(*runWithHistory_.timeTravel().framesAt(8));
  EXPECT_EQ(runWithHistory_.run().definition(), runWithHistory_.definition());
}

TEST_F(ARememberedRun, LooksBackWithAsManyThreadsAsItTracksWith) {
  for (std::int64_t k = 0; k < kRememberedFrames; ++k) {
    const auto frames = inputs_.source->next();
    ASSERT_TRUE(frames);
    track(*frames);
  }
  const auto threadsAt = [this](std::int64_t frame) {
    const TrackingRun* then =
        runWithHistory_.timeTravel().runAt(frame, runWithHistory_.run(), [] { return true; });
    return then != nullptr ? then->threadCount() : 0;
  };
  EXPECT_EQ(threadsAt(8), 1);
  runWithHistory_.setThreadCount(3);
  EXPECT_EQ(threadsAt(9), 3); // the run that stands at frame 8 goes on
}

TEST_F(ARememberedRun, StaysAsItWasWhenAnotherCannotBeMade) {
  RunDefinition unknown = *runWithHistory_.definition();
  unknown.method = "no such method";
  EXPECT_FALSE(runWithHistory_.change(unknown)); // not of this run
  EXPECT_FALSE(runWithHistory_.startNewRun(unknown, 0));
  EXPECT_TRUE(runWithHistory_.hasRun());
  EXPECT_EQ(runWithHistory_.definition()->method, "dewpoint");
  runWithHistory_.restart(77);
  EXPECT_EQ(runWithHistory_.definition()->seed, 77U);
  EXPECT_EQ(runWithHistory_.headFrame(), -1);
}

} // namespace
} // namespace dewpoint::tests
