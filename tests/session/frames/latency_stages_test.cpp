// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/frames/latency_stages.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

using namespace std::chrono_literals;
using StageClock = LatencyStages::Clock;

const StageClock::time_point kLight(1000s);

/// A live image that was captured at `kLight`, arrived after 10 ms, and was decoded 3 ms later.
FramePtr liveImage(TimeOrigin origin) {
  Frame frame;
  frame.origin = origin;
  frame.instants = {kLight, kLight + 10ms, kLight + 13ms};
  return std::make_shared<const Frame>(frame);
}

FrameSet setOf(const std::vector<FramePtr>& frames) {
  FrameSet set;
  set.frames = frames;
  return set;
}

constexpr double kAccuracy = 0.006; ///< relative, of DurationHistogram

TEST(LatencyStages, EachPartIsMeasuredFromTheOneBefore) {
  LatencyStages stages;
  stages.addFrames(setOf({liveImage(TimeOrigin::Driver), nullptr}), kLight + 20ms, kLight + 22ms);
  stages.addDrawingTime(0.016);
  const LiveLatency live = stages.summary();
  EXPECT_NEAR(live.capture.median, 0.010, kAccuracy * 0.010);
  EXPECT_NEAR(live.decode.median, 0.003, kAccuracy * 0.003);
  EXPECT_NEAR(live.wait.median, 0.007, kAccuracy * 0.007);
  EXPECT_NEAR(live.compute.p99, 0.002, kAccuracy * 0.002);
  EXPECT_NEAR(live.draw.median, 0.016, kAccuracy * 0.016);
  EXPECT_NEAR(live.total.median, 0.022, kAccuracy * 0.022); // from light to estimate
  EXPECT_EQ(live.imageCounts, (std::array<std::int64_t, kTimeOriginCount>{1, 0, 0}));
}

TEST(LatencyStages, WithoutACaptureTimeItBeginsAtTheArrival) {
  LatencyStages stages;
  stages.addFrames(setOf({liveImage(TimeOrigin::Arrival)}), kLight + 20ms, kLight + 22ms);
  const LiveLatency live = stages.summary();
  EXPECT_EQ(live.capture.longest, 0.0); // nobody knows it
  EXPECT_NEAR(live.total.median, 0.012, kAccuracy * 0.012);
  EXPECT_EQ(live.imageCounts[static_cast<std::size_t>(TimeOrigin::Arrival)], 1);
}

TEST(LatencyStages, RecordingsAreNotCounted) {
  LatencyStages stages;
  stages.addFrames(setOf({std::make_shared<const Frame>()}), kLight, kLight + 2ms);
  EXPECT_EQ(stages.summary().total.longest, 0.0);
  EXPECT_EQ(stages.summary().compute.longest, 0.0);
}

} // namespace
} // namespace dewpoint::tests
