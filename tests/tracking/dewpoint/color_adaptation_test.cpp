// SPDX-License-Identifier: GPL-3.0-or-later
// Parameter `color_adaptation` of method dewpoint: the color follows slow changes of light.
#include "tests/tracking/drawn_run.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dewpoint::tests {
namespace {

using drawn::Ball;
using drawn::Changes;

constexpr int kFrames = 300;

/// A ball on a circle in light that fades to a third.
std::shared_ptr<FrameSet> framesAt(const CameraRig& rig, int frame, bool hidden = false) {
  const double angle = 0.02 * frame;
  std::vector<Ball> balls;
  if (!hidden) {
    balls.push_back(
        {drawn::kMiddle + Eigen::Vector3d(0.08 * std::cos(angle), 0.08 * std::sin(angle), 0.0)});
  }
  auto set = drawn::framesOf(rig, balls, frame, {}, 0.0);
  const double gain = std::pow(1.0 / 3.0, std::clamp((frame - 30) / 250.0, 0.0, 1.0));
  for (std::size_t k = 0; k < rig.size(); ++k) {
    cv::Mat image = set->frames[k]->image * gain;
    drawn::addNoise(image, 2.0, std::uint32_t(frame), 99 + k);
    auto lit = std::make_shared<Frame>(*set->frames[k]);
    lit->image = image;
    set->frames[k] = lit;
  }
  return set;
}

const Changes kOn{{"start_x", 0.6}, {"start_y", 0.5}, {"color_adaptation", 1.0}};
const Changes kOff{{"start_x", 0.6}, {"start_y", 0.5}};

std::unique_ptr<Tracker> changedTracker(const CameraRig& rig, Changes changes) {
  auto tracker =
      makeTracker("dewpoint", drawn::parametersOf("dewpoint", changes), rig, {drawn::redBall()});
  (*tracker)->restart(4);
  return std::move(*tracker);
}

TEST(ColorAdaptation, FollowsTheLightInEachCamera) {
  const CameraRig rig = drawn::rigAround(2);
  const auto tracker = changedTracker(rig, kOn);
  ThreadTeam team;
  for (int frame = 0; frame < kFrames; ++frame) {
    tracker->beginFrame(framesAt(rig, frame));
    tracker->iterate(team);
    ASSERT_TRUE(sphereOf(*tracker).isValid) << frame;
  }
  const auto& colors = sphereOf(*tracker).colors;
  ASSERT_EQ(colors.size(), 2U);
  for (const ColorRanges& inUse : colors) {
    ASSERT_EQ(inUse.size(), 1U);
    const ColorRange& color = inUse[0];
    // A third of the light, and a lag of a second of the 250 / 30 s: 3^(30 / 250) = 1.14 more at
    // most; for the last 20 frames the light is steady.
    EXPECT_GT(color.intensityMin, drawn::kRed.intensityMin / 3.0 * 0.95);
    EXPECT_LT(color.intensityMin, drawn::kRed.intensityMin / 3.0 * 1.2);
  }
}

TEST(ColorAdaptation, OffNothingIsFollowed) {
  const CameraRig rig = drawn::rigAround(2);
  const auto tracker = changedTracker(rig, kOff);
  const auto switchedOff = changedTracker(rig, kOn);
  ParameterValues off = drawn::parametersOf("dewpoint", kOff);
  capability<Configurable>(*switchedOff)->configure(off);
  ThreadTeam team;
  for (int frame = 0; frame < 120; ++frame) {
    for (Tracker* one : {tracker.get(), switchedOff.get()}) {
      one->beginFrame(framesAt(rig, frame));
      one->iterate(team);
      ASSERT_TRUE(sphereOf(*one).colors.empty()) << frame;
    }
    ASSERT_EQ(sphereOf(*tracker).mean, sphereOf(*switchedOff).mean) << frame;
  }
}

TEST(ColorAdaptation, AHiddenTargetsColorIsKept) {
  const CameraRig rig = drawn::rigAround(2);
  const auto tracker = changedTracker(rig, kOn);
  ThreadTeam team;
  std::vector<ColorRanges> before;
  for (int frame = 0; frame < 200; ++frame) {
    const bool hidden = frame >= 120 && frame < 150;
    tracker->beginFrame(framesAt(rig, frame, hidden));
    tracker->iterate(team);
    // What the look at frame 119 changed shows at 120.
    if (frame == 120) {
      before = sphereOf(*tracker).colors;
    } else if (hidden) {
      ASSERT_EQ(sphereOf(*tracker).colors, before) << frame;
    }
  }
  EXPECT_NE(sphereOf(*tracker).colors, before) << "it is back";
}

TEST(ColorAdaptation, CopiesAndThreadsGiveTheSameBits) {
  const CameraRig rig = drawn::rigAround(2);
  const auto straight = changedTracker(rig, kOn);
  auto copied = changedTracker(rig, kOn);
  ThreadTeam one(1);
  ThreadTeam three(3);
  for (int frame = 0; frame < 160; ++frame) {
    if (frame % 20 == 7) {
      copied = capability<Copyable>(*copied)->clone();
    }
    straight->beginFrame(framesAt(rig, frame));
    copied->beginFrame(framesAt(rig, frame));
    straight->iterate(one);
    copied->iterate(three);
    ASSERT_EQ(sphereOf(*straight).mean, sphereOf(*copied).mean) << frame;
    ASSERT_EQ(sphereOf(*straight).colors, sphereOf(*copied).colors) << frame;
  }
  EXPECT_FALSE(sphereOf(*straight).colors.empty());
  // A restart is a new beginning.
  straight->restart(4);
  straight->beginFrame(framesAt(rig, 0));
  straight->iterate(one);
  EXPECT_TRUE(sphereOf(*straight).colors.empty());
}

} // namespace
} // namespace dewpoint::tests
