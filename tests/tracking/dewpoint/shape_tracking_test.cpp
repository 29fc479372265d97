// SPDX-License-Identifier: GPL-3.0-or-later
// Method `dewpoint` on drawn targets that are no balls.
#include "tests/observation/drawn_ellipsoids.h"
#include "tests/tracking/drawn_run.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>

namespace dewpoint::tests {
namespace {

using drawn::kVga;

/// A stick of 20 cm x 3 cm that drifts and tumbles.
Ellipsoid stickAt(int frame) {
  const double t = frame / 30.0;
  return drawn::ellipsoid(drawn::kMiddle + Eigen::Vector3d(0.08 * std::sin(t), 0.05 * t, 0.0),
                          {0.1, 0.015, 0.015}, 0.3 + 0.8 * t);
}

std::shared_ptr<FrameSet> framesWith(const CameraRig& rig, const std::vector<Ellipsoid>& solids,
                                     int index) {
  auto set = std::make_shared<FrameSet>();
  set->index = index;
  set->time = timeStamp(index / 30.0);
  for (std::size_t k = 0; k < rig.size(); ++k) {
    auto frame = std::make_shared<Frame>();
    frame->index = index;
    frame->captureTime = set->time;
    frame->image = drawn::wall(rig[k]);
    for (const Ellipsoid& solid : solids) {
      drawn::paint(frame->image, rig[k], solid);
    }
    set->frames.push_back(std::move(frame));
  }
  return set;
}

/// Tracks one red target over drawn frames.
class ShapeRun {
public:
  explicit ShapeRun(TargetShape shape, double radius = 0.0)
      : rig_(drawn::rigAround(2, kVga)),
        tracker_(drawn::parametersOf("dewpoint"), rig_, {targetOf(shape, radius)}) {
    tracker_.restart(1);
  }
  static Target targetOf(TargetShape shape, double radius) {
    Target target = drawn::redBall(radius);
    target.shape = shape;
    return target;
  }
  SphereEstimate show(const std::vector<Ellipsoid>& solids) {
    ThreadTeam team;
    tracker_.beginFrame(framesWith(rig_, solids, frame_++));
    tracker_.iterate(team);
    return std::get<SphereEstimate>(tracker_.estimate(0));
  }
  DewpointTracker& tracker() { return tracker_; }

private:
  CameraRig rig_;
  DewpointTracker tracker_;
  int frame_ = 0;
};

double longestAxis(const SphereEstimate& estimate) {
  return std::sqrt(
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(*estimate.extent).eigenvalues().maxCoeff());
}

// A tenth of its length is 20 mm; the outlines alone have its center within 2.
TEST(ShapeTracking, FollowsAStickThatTumbles) {
  for (const TargetShape shape : {TargetShape::Auto, TargetShape::Any}) {
    ShapeRun run(shape);
    for (int frame = 0; frame < 40; ++frame) {
      const SphereEstimate estimate = run.show({stickAt(frame)});
      if (shape == TargetShape::Auto && frame < 10) {
        continue; // what it is shows within a third of a second
      }
      ASSERT_TRUE(estimate.isValid) << frame;
      ASSERT_TRUE(estimate.extent) << frame;
      EXPECT_LT((estimate.mean - stickAt(frame).center).norm(), 0.01) << frame;
      EXPECT_GT(estimate.existenceProbability, 0.9) << frame;
      EXPECT_EQ(estimate.seeingCameraCount, 2) << frame;
      if (frame > 5) {
        EXPECT_NEAR(longestAxis(estimate), 0.1, 0.025) << frame;
      }
    }
  }
}

TEST(ShapeTracking, ABallStaysABall) {
  ShapeRun run(TargetShape::Auto);
  const Ellipsoid ball = drawn::ellipsoid(drawn::kMiddle, {0.035, 0.035, 0.035});
  for (int frame = 0; frame < 20; ++frame) {
    const SphereEstimate estimate = run.show({ball});
    ASSERT_TRUE(estimate.isValid) << frame;
    EXPECT_FALSE(estimate.extent) << frame;
    EXPECT_LT((estimate.mean - ball.center).norm(), 0.002) << frame;
  }
}

// Taken for anything, a ball has a ball's extent.
TEST(ShapeTracking, ABallMayBeTakenForAnything) {
  ShapeRun run(TargetShape::Any);
  const Ellipsoid ball = drawn::ellipsoid(drawn::kMiddle, {0.035, 0.035, 0.035});
  SphereEstimate estimate;
  for (int frame = 0; frame < 20; ++frame) {
    estimate = run.show({ball});
  }
  ASSERT_TRUE(estimate.isValid && estimate.extent);
  EXPECT_LT((estimate.mean - ball.center).norm(), 0.002);
  EXPECT_NEAR(estimate.radius, 0.035, 0.0035);
}

TEST(ShapeTracking, WhatHasGoneIsNotDeclared) {
  ShapeRun run(TargetShape::Any);
  for (int frame = 0; frame < 20; ++frame) {
    run.show({stickAt(frame)});
  }
  SphereEstimate estimate;
  for (int frame = 0; frame < 5; ++frame) {
    estimate = run.show({});
  }
  EXPECT_FALSE(estimate.isValid);
  EXPECT_LT(estimate.existenceProbability, 0.05);
  // It is found again elsewhere.
  const Ellipsoid elsewhere =
      drawn::ellipsoid(drawn::kMiddle - Eigen::Vector3d(0.2, 0.1, 0.0), {0.1, 0.015, 0.015}, 1.0);
  estimate = run.show({elsewhere});
  EXPECT_TRUE(estimate.isValid);
  EXPECT_LT((estimate.mean - elsewhere.center).norm(), 0.01);
}

// A copy goes on with the same bits.
TEST(ShapeTracking, ACopyGoesOnAlike) {
  ShapeRun run(TargetShape::Auto);
  for (int frame = 0; frame < 15; ++frame) {
    run.show({stickAt(frame)});
  }
  const auto copy = run.tracker().clone();
  const CameraRig rig = drawn::rigAround(2, kVga);
  ThreadTeam team;
  copy->beginFrame(framesWith(rig, {stickAt(15)}, 15));
  copy->iterate(team);
  const SphereEstimate own = run.show({stickAt(15)});
  const auto other = std::get<SphereEstimate>(copy->estimate(0));
  EXPECT_EQ(own.mean, other.mean);
  EXPECT_EQ(own.covariance, other.covariance);
}

// What the user says holds from the next frame on.
TEST(ShapeTracking, TheShapeCanBeChanged) {
  ShapeRun run(TargetShape::Any);
  EXPECT_TRUE(run.show({stickAt(0)}).extent);
  run.tracker().setTargets({ShapeRun::targetOf(TargetShape::Ball, 0.0)});
  EXPECT_FALSE(run.show({stickAt(1)}).extent);
  run.tracker().setTargets({ShapeRun::targetOf(TargetShape::Any, 0.0)});
  EXPECT_TRUE(run.show({stickAt(2)}).extent);
}

} // namespace
} // namespace dewpoint::tests
