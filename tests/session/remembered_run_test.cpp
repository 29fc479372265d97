// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/remembered_run.h"
#include "core/session/run/frame_loop.h"
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
    ASSERT_TRUE(kept_.replace(*kept_.definition(), 0));
    kept_.keepHistory(*inputs_.source, std::size_t{64} << 20);
  }

  /// Tracks a frame; what is believed of the target then.
  TrajectorySample track(const FrameSetPtr& frames) {
    kept_.begin(frames);
    kept_.catchUp();
    EXPECT_TRUE(trackOneFrame(kept_.run(), {}));
    kept_.record();
    return kept_.run().samples().at(0);
  }
  void growTarget() {
    RunDefinition larger = *kept_.definition();
    larger.targets[0].radius *= 1.2;
    EXPECT_TRUE(kept_.change(std::move(larger)));
  }

  SessionInputs inputs_ = drawnInputs("dewpoint", kRememberedFrames);
  RememberedRun kept_{RunDefinition::of(inputs_.project), 1};
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
  EXPECT_EQ(kept_.head(), kRememberedFrames - 1);
  kept_.setThreads(3);
  ASSERT_TRUE(kept_.travel().goBack(kept_.run(), 8, [] { return true; }));
  kept_.travel().forgetFrom(8);
  for (std::int64_t k = 8; k < kRememberedFrames; ++k) {
    const auto frames = kept_.travel().frames(k);
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
  const double radius = kept_.definition()->targets[0].radius;
  growTarget();
  ASSERT_TRUE(kept_.travel().goBack(kept_.run(), 8, [] { return true; }));
  EXPECT_EQ(kept_.run().definition()->targets[0].radius, radius); // as it was then
  EXPECT_GT(kept_.definition()->targets[0].radius, radius);
  kept_.travel().forgetFrom(8);
  track(*kept_.travel().frames(8));
  EXPECT_EQ(kept_.run().definition(), kept_.definition());
}

TEST_F(ARememberedRun, LooksBackWithAsManyThreadsAsItTracksWith) {
  for (std::int64_t k = 0; k < kRememberedFrames; ++k) {
    const auto frames = inputs_.source->next();
    ASSERT_TRUE(frames);
    track(*frames);
  }
  const auto threadsAt = [this](std::int64_t frame) {
    const TrackingRun* then = kept_.travel().runAt(frame, kept_.run(), [] { return true; });
    return then != nullptr ? then->threadCount() : 0;
  };
  EXPECT_EQ(threadsAt(8), 1);
  kept_.setThreads(3);
  EXPECT_EQ(threadsAt(9), 3); // the run that stands at frame 8 goes on
}

TEST_F(ARememberedRun, StaysAsItWasWhenAnotherCannotBeMade) {
  RunDefinition unknown = *kept_.definition();
  unknown.method = "no such method";
  EXPECT_FALSE(kept_.change(unknown)); // not of this run
  EXPECT_FALSE(kept_.replace(unknown, 0));
  EXPECT_TRUE(kept_.exists());
  EXPECT_EQ(kept_.definition()->method, "dewpoint");
  kept_.restart(77);
  EXPECT_EQ(kept_.definition()->seed, 77U);
  EXPECT_EQ(kept_.head(), -1);
}

} // namespace
} // namespace dewpoint::tests
