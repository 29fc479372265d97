// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/view/video_plan.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

using FrameNumbers = std::vector<std::int64_t>;

/// Frames from 100 on, 10 a second.
std::vector<FrameTime> tenPerSecond(int count) {
  std::vector<FrameTime> frames;
  for (int k = 0; k < count; ++k) {
    frames.push_back({100 + k, 5.0 + 0.1 * k});
  }
  return frames;
}

FrameNumbers planOf(const std::vector<FrameTime>& frames, std::optional<double> speed,
                    double framesPerSecond) {
  const auto plan = chooseVideoFrames(frames, {speed, framesPerSecond});
  return plan ? *plan : FrameNumbers();
}

TEST(VideoPlan, AtItsOwnSpeedAndRateEachFrameIsShownOnce) {
  EXPECT_EQ(planOf(tenPerSecond(4), 1.0, 10.0), (FrameNumbers{100, 101, 102, 103}));
}

TEST(VideoPlan, RepeatsAndLeavesOut) {
  // Half of the speed, or twice the rate: each twice. What is as close to two is the earlier.
  EXPECT_EQ(planOf(tenPerSecond(3), 0.5, 10.0), (FrameNumbers{100, 100, 101, 101, 102, 102}));
  EXPECT_EQ(planOf(tenPerSecond(3), 1.0, 20.0), (FrameNumbers{100, 100, 101, 101, 102, 102}));
  EXPECT_EQ(planOf(tenPerSecond(6), 2.0, 10.0), (FrameNumbers{100, 102, 104}));
  EXPECT_EQ(planOf(tenPerSecond(16), 8.0, 10.0), (FrameNumbers{100, 108}));
  EXPECT_EQ(planOf(tenPerSecond(100), 0.1, 60.0).size(), 6000U);
}

TEST(VideoPlan, EveryFrameOnceWhateverItsTime) {
  std::vector<FrameTime> frames = tenPerSecond(3);
  frames.push_back({110, 60.0});
  EXPECT_EQ(planOf(frames, std::nullopt, 25.0), (FrameNumbers{100, 101, 102, 110}));
}

TEST(VideoPlan, AGapLastsAsLongAsItLasted) {
  const std::vector<FrameTime> frames{{0, 0.0}, {1, 0.1}, {6, 0.6}, {7, 0.7}};
  EXPECT_EQ(planOf(frames, 1.0, 10.0), (FrameNumbers{0, 1, 1, 1, 6, 6, 6, 7}));
}

TEST(VideoPlan, JitterNeitherRepeatsNorLosesAFrame) {
  std::vector<FrameTime> frames = tenPerSecond(50);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    frames[k].timeSeconds += k % 3 == 0 ? 0.03 : -0.02;
  }
  frames[0].timeSeconds = 5.0;
  frames[49].timeSeconds = 9.9;
  const FrameNumbers plan = planOf(frames, 1.0, 10.0);
  ASSERT_EQ(plan.size(), 50U);
  for (std::size_t k = 0; k < plan.size(); ++k) {
    EXPECT_EQ(plan[k], frames[k].frame);
  }
}

TEST(VideoPlan, ASingleFrameIsAVideo) {
  EXPECT_EQ(planOf({{7, 1.0}}, 1.0, 30.0), FrameNumbers{7});
  EXPECT_EQ(planOf({{7, 1.0}}, 8.0, 30.0), FrameNumbers{7});
}

TEST(VideoPlan, SaysWhatIsWrong) {
  const auto frames = tenPerSecond(3);
  for (const auto& result :
       {chooseVideoFrames({}, {}), chooseVideoFrames(frames, {0.0, 30.0}),
        chooseVideoFrames(frames, {1.0, 0.0}), chooseVideoFrames(frames, {std::nullopt, -1.0}),
        chooseVideoFrames(std::vector<FrameTime>{{0, 0.0}, {1, 1e9}}, {0.1, 60.0})}) {
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::BadValue);
  }
}

} // namespace
} // namespace dewpoint::tests
