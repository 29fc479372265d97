// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/event_metrics.h"
#include "tests/base/not_a_number.h"
#include "tests/experiment/metrics/track_frames.h"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

namespace dewpoint::tests {
namespace {

constexpr double kEventGate = 0.03;

/// One letter a frame, numbered from 100: f followed, w wrong (1 m off), n declared but nowhere,
/// u undeclared; a absent and rightly undeclared, g absent but declared (a ghost).
std::vector<TrackFrame> story(std::string_view letters) {
  std::vector<TrackFrame> frames;
  for (const char letter : letters) {
    PointsOnAxis truth;
    PointsOnAxis estimates;
    if (letter != 'a' && letter != 'g')
      truth.emplace_back(1, 0.0);
    if (letter == 'f' || letter == 'w' || letter == 'n' || letter == 'g')
      estimates.emplace_back(7, letter == 'f' ? 0.01 : letter == 'n' ? kNotANumber : 1.0);
    frames.push_back(frameOnAxis(truth, estimates, 100 + static_cast<std::int64_t>(frames.size())));
  }
  return frames;
}

std::vector<TargetFrame> targetStory(std::string_view letters) {
  return framesOfTarget(story(letters), 1, 7);
}

TEST(EventMetrics, TargetFramesPickOneIdentity) {
  const std::vector<TrackFrame> frames{frameOnAxis({{1, 0.0}, {2, 5.0}}, {{7, 0.1}, {8, 5.1}}, 42)};
  const auto second = framesOfTarget(frames, 2, 8);
  ASSERT_EQ(second.size(), 1U);
  EXPECT_EQ(second[0].frame, 42);
  EXPECT_EQ(second[0].truth->x(), 5.0);
  EXPECT_EQ(second[0].estimate->x(), 5.1);
  EXPECT_FALSE(framesOfTarget(frames, 3, 9)[0].truth.has_value());
  EXPECT_FALSE(framesOfTarget(frames, 3, 9)[0].estimate.has_value());
}

TEST(EventMetrics, FramesToConverge) {
  EXPECT_EQ(framesToConverge(targetStory("fffff"), kEventGate), 0);
  EXPECT_EQ(framesToConverge(targetStory("wwfffff"), kEventGate), 2);
  EXPECT_EQ(framesToConverge(targetStory("ffffwfffff"), kEventGate),
            5); // four in a row are too few
  EXPECT_EQ(framesToConverge(targetStory("ffuffnfffff"), kEventGate), 6);
  EXPECT_EQ(framesToConverge(targetStory("ffffwffff"), kEventGate), std::nullopt);
  EXPECT_EQ(framesToConverge({}, kEventGate), std::nullopt);
}

// The gate itself is outside, as in core/trajectory's evaluation.
TEST(EventMetrics, TheGateIsOutside) {
  TargetFrame frame;
  frame.truth = Eigen::Vector3d::Zero();
  frame.estimate = Eigen::Vector3d(0.03, 0.0, 0.0);
  EXPECT_FALSE(frame.isFollowed(0.03));
  EXPECT_TRUE(frame.isFollowed(0.030001));
}

TEST(EventMetrics, FramesToReacquireCountFromTheEvent) {
  const auto jump = targetStory("ffffffwwwfffff"); // jump at frame 106
  EXPECT_EQ(framesToReacquire(jump, 106, kEventGate), 3);
  EXPECT_EQ(framesToReacquire(jump, 100, kEventGate), 0);
  EXPECT_EQ(framesToReacquire(jump, 109, kEventGate), 0);
  EXPECT_EQ(framesToReacquire(jump, 110, kEventGate), std::nullopt); // four frames are left
  EXPECT_EQ(framesToReacquire(jump, 500, kEventGate), std::nullopt);
}

TEST(EventMetrics, FramesToDeclareLoss) {
  EXPECT_EQ(framesToDeclareLoss(targetStory("fffggga"), 103), 3);
  EXPECT_EQ(framesToDeclareLoss(targetStory("fffaa"), 103), 0);
  EXPECT_EQ(framesToDeclareLoss(targetStory("fffggg"), 103), std::nullopt);  // never
  EXPECT_EQ(framesToDeclareLoss(targetStory("fffggfu"), 103), std::nullopt); // came back first
  EXPECT_EQ(framesToDeclareLoss(targetStory("fffgga"), 104), 1);
}

// Of eight frames two are without target: w, n and u of the other six are lost.
TEST(EventMetrics, LostFrames) {
  const Proportion lost = lostFrameShare(targetStory("ffwnufag"), kEventGate);
  EXPECT_EQ(lost.count, 3);
  EXPECT_EQ(lost.total, 6);
  EXPECT_DOUBLE_EQ(lost.value(), 0.5);
}

// A frame in which nobody can see the target is not held against the method.
TEST(EventMetrics, InvisibleFramesAreNotLost) {
  auto frames = targetStory("fuuf");
  frames[1].isVisible = false;
  EXPECT_EQ(lostFrameShare(frames, kEventGate).count, 1);
  EXPECT_EQ(lostFrameShare(frames, kEventGate).total, 3);
}

// w, n and g are false alarms; undeclared frames are not.
TEST(EventMetrics, FalseAlarms) {
  const Proportion alarms = falseAlarmFrameShare(story("ffwnufag"), kEventGate);
  EXPECT_EQ(alarms.count, 3);
  EXPECT_EQ(alarms.total, 8);
  EXPECT_EQ(falseAlarmFrameShare({}, kEventGate).total, 0);
}

// Any truth will do: an estimate that swapped to the neighbor is no false alarm. A frame counts
// once, however many alarms it has.
TEST(EventMetrics, FalseAlarmsLookAtAllTruths) {
  const std::vector<TrackFrame> frames{
      frameOnAxis({{1, 0.0}, {2, 5.0}}, {{7, 5.01}, {8, 5.02}}),
      frameOnAxis({{1, 0.0}, {2, 5.0}}, {{7, 0.0}, {8, 2.0}, {9, 3.0}})};
  EXPECT_EQ(falseAlarmFrameShare(frames, kEventGate).count, 1);
}

} // namespace
} // namespace dewpoint::tests
