// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/baselines/rig_start.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

/// 201 x 201 pixels, focal length 200 px: the image's borders lie at a slope of 1/2.
Camera cameraAt(const Eigen::Vector3d& position, const Eigen::Vector3d& target) {
  Camera camera;
  camera.intrinsics = {201, 201, 200.0, 200.0, 100.0, 100.0};
  camera.cameraFromWorld = lookAt(position, target);
  return camera;
}

/// At 1 m from the origin on x and on y, both looking at it: their axes meet there.
CameraRig twoCameras() {
  return {cameraAt({1, 0, 0}, {0, 0, 0}), cameraAt({0, 1, 0}, {0, 0, 0})};
}

TEST(CommonView, IsTheBoxOfWhatBothSee) {
  // The first sees |y|, |z| <= (1 - x) / 2, the second |x|, |z| <= (1 - y) / 2, each up to 2 m
  // away. Largest x: where y = -(1 - x) / 2 and x = (1 - y) / 2 meet, 0.6. Smallest x: on the
  // second's border, 2 m away, at -1 / sqrt(1.25) = -0.894. Largest z: on the upper border of one,
  // 2 m away, where the other's border is met: depth d with 1.25 d² + (1 - d)² = 4, d = 1.682,
  // z = d / 2 = 0.841. Points lie 50 mm apart on a ray.
  const auto view = commonView(twoCameras());
  ASSERT_TRUE(view.has_value());
  const Eigen::Vector3d low = view->center - view->half;
  const Eigen::Vector3d high = view->center + view->half;
  for (const Eigen::Index axis : {0, 1}) {
    EXPECT_NEAR(low[axis], -0.894, 0.06);
    EXPECT_NEAR(high[axis], 0.6, 0.06);
  }
  EXPECT_NEAR(low.z(), -0.841, 0.06);
  EXPECT_NEAR(high.z(), 0.841, 0.06);
}

TEST(CommonView, IsThatOfTwoWhereAThirdLooksAway) {
  CameraRig rig = twoCameras();
  rig.push_back(cameraAt({0, 0, 5}, {5, 0, 5}));
  const auto view = commonView(rig);
  ASSERT_TRUE(view.has_value());
  EXPECT_NEAR(view->center.x() + view->half.x(), 0.6, 0.06) << "as without the third";
}

TEST(CommonView, NeedsTwoCamerasThatSeeSomethingTogether) {
  EXPECT_FALSE(commonView({}).has_value());
  EXPECT_FALSE(commonView({cameraAt({1, 0, 0}, {0, 0, 0})}).has_value());
  EXPECT_FALSE(
      commonView({cameraAt({1, 0, 0}, {2, 0, 0}), cameraAt({-1, 0, 0}, {-2, 0, 0})}).has_value())
      << "back to back";
}

TEST(StartFromRig, IsThePartOfTheRunsVolumeThatTheCamerasSee) {
  ScenarioRun run;
  run.rig = twoCameras();
  run.startCenter = {0.5, 0.0, 0.0};
  run.startHalf = {0.5, 0.1, 5.0};
  const StartVolume start = startFromRig(run);
  EXPECT_NEAR(start.center.x() - start.half.x(), 0.0, 1e-12) << "the run's";
  EXPECT_NEAR(start.center.x() + start.half.x(), 0.6, 0.06) << "the cameras'";
  EXPECT_NEAR(start.center.y(), 0.0, 1e-12);
  EXPECT_NEAR(start.half.y(), 0.1, 1e-12);
  EXPECT_NEAR(start.half.z(), 0.841, 0.06);
}

TEST(StartFromRig, IsAllThatTheCamerasSeeForAPoint) {
  ScenarioRun run;
  run.rig = twoCameras();
  run.startCenter = {0.5, 0.0, 0.0};
  const StartVolume start = startFromRig(run);
  const auto view = commonView(run.rig);
  ASSERT_TRUE(view.has_value());
  EXPECT_EQ(start.center, view->center);
  EXPECT_EQ(start.half, view->half);
}

TEST(StartFromRig, IsTheRunsOwnWhereNothingIsSeen) {
  ScenarioRun run;
  run.rig = twoCameras();
  run.startCenter = {8.0, 0.0, 0.0};
  run.startHalf = {1.0, 1.0, 1.0};
  EXPECT_EQ(startFromRig(run).center, run.startCenter);
  EXPECT_EQ(startFromRig(run).half, run.startHalf);
  run.rig.pop_back();
  EXPECT_EQ(startFromRig(run).center, run.startCenter) << "one camera";
}

} // namespace
} // namespace dewpoint::tests
