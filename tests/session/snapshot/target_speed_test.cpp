// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/snapshot/snapshot.h"
#include "core/session/snapshot/target_speed.h"

#include <gtest/gtest.h>

#include <memory>

namespace dewpoint::tests {
namespace {

constexpr double kFrameSeconds = 0.1;
constexpr double kSpeed = 2.0; // meters per second along x

/// A frame of a target that goes along x.
TrackSnapshot frameAt(std::int64_t frame, bool isHeld = true) {
  TrackSnapshot snapshot;
  snapshot.frame = frame;
  auto frames = std::make_shared<FrameSet>();
  frames->time = timeStamp(kFrameSeconds * static_cast<double>(frame));
  snapshot.frames = frames;
  SphereEstimate sphere;
  sphere.mean.x() = kSpeed * kFrameSeconds * static_cast<double>(frame);
  sphere.isValid = isHeld;
  snapshot.targets.emplace_back().estimate = sphere;
  snapshot.targets.front().target.name = "ball";
  return snapshot;
}

void show(TargetSpeed& speed, const TrackSnapshot& snapshot) {
  speed.add(snapshot, snapshot.targets.front());
}

TEST(TargetSpeed, NeedsASecondFrame) {
  TargetSpeed speed;
  EXPECT_FALSE(speed.metersPerSecond());
  show(speed, frameAt(0));
  EXPECT_FALSE(speed.metersPerSecond());
  show(speed, frameAt(1));
  ASSERT_TRUE(speed.metersPerSecond());
  EXPECT_NEAR(*speed.metersPerSecond(), kSpeed, 1e-9);
  show(speed, frameAt(1)); // the same frame again
  EXPECT_NEAR(*speed.metersPerSecond(), kSpeed, 1e-9);
}

TEST(TargetSpeed, ANewNameChangesNothing) {
  TargetSpeed speed;
  show(speed, frameAt(0));
  show(speed, frameAt(1));
  TrackSnapshot renamed = frameAt(1);
  renamed.targets.front().target.name = "the same ball";
  show(speed, renamed);
  ASSERT_TRUE(speed.metersPerSecond());
  EXPECT_NEAR(*speed.metersPerSecond(), kSpeed, 1e-9);
  TrackSnapshot other = frameAt(2); // of which nothing is known
  other.targets.front().target.name = "another";
  show(speed, other);
  EXPECT_FALSE(speed.metersPerSecond());
}

TEST(TargetSpeed, FramesThatTheScreenLeftOutAreNoGap) {
  TargetSpeed speed;
  for (const std::int64_t frame : {0, 3, 7}) {
    show(speed, frameAt(frame));
  }
  ASSERT_TRUE(speed.metersPerSecond());
  EXPECT_NEAR(*speed.metersPerSecond(), kSpeed, 1e-9);
}

TEST(TargetSpeed, NothingIsSaidAcrossAGap) {
  TargetSpeed speed;
  show(speed, frameAt(0));
  show(speed, frameAt(100));
  EXPECT_FALSE(speed.metersPerSecond());
  show(speed, frameAt(101));
  ASSERT_TRUE(speed.metersPerSecond());
  EXPECT_NEAR(*speed.metersPerSecond(), kSpeed, 1e-9);
  show(speed, frameAt(102, false));
  EXPECT_FALSE(speed.metersPerSecond());
}

TEST(TargetSpeed, OneMayStepBack) {
  TargetSpeed speed;
  for (std::int64_t frame = 0; frame < 10; ++frame) {
    show(speed, frameAt(frame));
  }
  show(speed, frameAt(4));
  ASSERT_TRUE(speed.metersPerSecond());
  EXPECT_NEAR(*speed.metersPerSecond(), kSpeed, 1e-9);
}

TEST(TargetSpeed, AnotherTargetOrRunBeginsAgain) {
  TargetSpeed speed;
  show(speed, frameAt(0));
  show(speed, frameAt(1));
  TrackSnapshot other = frameAt(2);
  other.targets.front().target.name = "other ball";
  show(speed, other);
  EXPECT_FALSE(speed.metersPerSecond());
  other = frameAt(3);
  other.targets.front().target.name = "other ball";
  show(speed, other);
  EXPECT_TRUE(speed.metersPerSecond());
  other.seed += 1;
  show(speed, other);
  EXPECT_FALSE(speed.metersPerSecond());
}

TEST(TargetSpeed, FollowsALongRun) {
  TargetSpeed speed;
  for (std::int64_t frame = 0; frame < 1000; ++frame) {
    show(speed, frameAt(frame));
  }
  ASSERT_TRUE(speed.metersPerSecond());
  EXPECT_NEAR(*speed.metersPerSecond(), kSpeed, 1e-9);
}

} // namespace
} // namespace dewpoint::tests
