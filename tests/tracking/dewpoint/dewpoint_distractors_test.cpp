// SPDX-License-Identifier: GPL-3.0-or-later
// Method `dewpoint` where something else has the target's color: it doubts, or is not misled.
#include "core/tracking/dewpoint/tracked_objects.h"
#include "tests/tracking/drawn_run.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dewpoint::tests {
namespace {

using drawn::Ball;
using drawn::DrawnRun;
using drawn::redBall;
using drawn::rigAround;

/// Paints a poster of the ball's color into the image of one camera, behind the balls.
FrameSetPtr beforePoster(const CameraRig& rig, const Eigen::Vector3d& place, int frame) {
  auto set = drawn::framesOf(rig, {Ball{place}}, frame, {}, 0.0);
  auto first = std::make_shared<Frame>(*set->frames[0]);
  first->image = drawn::wall(rig[0]);
  first->image(cv::Rect(150, 60, 100, 120)) = cv::Scalar(30, 20, 190);
  drawn::paint(first->image, rig[0], Ball{place});
  set->frames[0] = first;
  for (std::size_t camera = 0; camera < set->frames.size(); ++camera) {
    auto noisy = std::make_shared<Frame>(*set->frames[camera]);
    noisy->image = noisy->image.clone();
    drawn::addNoise(noisy->image, 3.0, static_cast<std::uint32_t>(frame), 99 + camera);
    set->frames[camera] = noisy;
  }
  return set;
}

// The ball is beside a poster of its color at first, then before it: by then the poster is known.
TEST(DewpointDistractors, APosterOfItsColorIsNotTheTarget) {
  DrawnRun run(rigAround(2), {redBall()});
  for (int frame = 0; frame < 90; ++frame) {
    const Eigen::Vector3d place =
        drawn::kMiddle + Eigen::Vector3d(-0.15 + 0.0035 * std::max(0, frame - 25), 0.0, 0.0);
    const SphereEstimate& estimate = run.showSet(beforePoster(run.rig(), place, frame));
    EXPECT_TRUE(estimate.isValid) << frame;
    EXPECT_LT((estimate.mean - place).norm(), 0.02) << frame;
  }
}

// Nothing but posters of its color: something round within them is never surely the target.
TEST(DewpointDistractors, APartOfAPosterIsNeverSurelyTheTarget) {
  DrawnRun run(rigAround(2), {redBall()});
  for (int frame = 0; frame < 60; ++frame) {
    auto set = drawn::framesOf(run.rig(), {}, frame);
    for (std::size_t camera = 0; camera < set->frames.size(); ++camera) {
      auto shown = std::make_shared<Frame>(*set->frames[camera]);
      shown->image(cv::Rect(100, 60, 120, 120)) = cv::Scalar(30, 20, 190);
      drawn::addNoise(shown->image, 3.0, static_cast<std::uint32_t>(frame), 99 + camera);
      set->frames[camera] = shown;
    }
    EXPECT_LE(run.showSet(set).existenceProbability, 0.9) << frame;
  }
}

// Two balls alike and one target: no image tells which it is, somebody has to.
TEST(DewpointDistractors, OfTwoBallsAlikeTheTargetIsAmbiguousUntilSomebodySaysWhichItIs) {
  const Eigen::Vector3d one = drawn::kMiddle + Eigen::Vector3d(-0.1, 0.0, 0.0);
  const Eigen::Vector3d other = drawn::kMiddle + Eigen::Vector3d(0.1, 0.0, 0.0);
  DrawnRun run(rigAround(2), {redBall()});
  for (int frame = 0; frame < 30; ++frame) {
    const SphereEstimate estimate = run.show({Ball{one}, Ball{other}});
    EXPECT_TRUE(frame < 2 || estimate.isAmbiguous) << frame;
  }
  ThreadTeam team(1);
  run.tracker().correctPosition(0, {other, 1e-4 * Eigen::Matrix3d::Identity()}, team);
  for (int frame = 30; frame < 60; ++frame) {
    const SphereEstimate estimate = run.show({Ball{one}, Ball{other}});
    EXPECT_FALSE(estimate.isAmbiguous) << frame;
    EXPECT_LT((estimate.mean - other).norm(), 5e-3) << frame;
  }
}

TEST(DewpointDistractors, ABallAloneIsNotAmbiguous) {
  const auto place = [](int frame) -> Eigen::Vector3d {
    return drawn::kMiddle + Eigen::Vector3d(-0.15 + 0.006 * frame, 0.05, 0.02);
  };
  DrawnRun run(rigAround(2), {redBall()});
  for (int frame = 0; frame < 30; ++frame) {
    EXPECT_FALSE(run.show({Ball{place(frame)}}).isAmbiguous) << frame;
  }
}

// A run that goes back is a copy: it must forget empty places in the same frame.
TEST(DewpointDistractors, ACopyKnowsForHowLongATargetWasNotFound) {
  TrackedObjects objects({redBall()}, rigAround(2));
  objects[0].secondsSinceTracked = 3.0;
  EXPECT_EQ(TrackedObjects(objects)[0].secondsSinceTracked, 3.0);
}

} // namespace
} // namespace dewpoint::tests
