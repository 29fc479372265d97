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
CameraRig crossedCameras() {
  return {cameraAt({1, 0, 0}, {0, 0, 0}), cameraAt({0, 1, 0}, {0, 0, 0})};
}

TEST(CommonView, IsWhatAllCamerasSee) {
  CameraRig rig = crossedCameras();
  const auto both = commonViewVolume(rig);
  ASSERT_TRUE(both.has_value());
  EXPECT_NEAR(both->center.x() + both->halfSize.x(), 0.6, 0.06);
  // The third stands half a meter above the origin, and sees nothing above itself.
  rig.push_back(cameraAt({0, 0, 0.5}, {0, 1e-9, 0}));
  const auto all = commonViewVolume(rig);
  ASSERT_TRUE(all.has_value());
  EXPECT_NEAR(both->center.z() + both->halfSize.z(), 0.656, 0.06);
  EXPECT_LT(all->center.z() + all->halfSize.z(), 0.5);
}

TEST(CommonView, IsThatOfTwoWhereAThirdLooksAway) {
  CameraRig rig = crossedCameras();
  rig.push_back(cameraAt({0, 0, 5}, {5, 0, 5}));
  const auto view = commonViewVolume(rig);
  ASSERT_TRUE(view.has_value());
  EXPECT_NEAR(view->center.x() + view->halfSize.x(), 0.6, 0.06) << "as without the third";
}

TEST(CommonView, NeedsTwoCamerasThatSeeSomethingTogether) {
  EXPECT_FALSE(commonViewVolume({}).has_value());
  EXPECT_FALSE(commonViewVolume({cameraAt({1, 0, 0}, {0, 0, 0})}).has_value());
  EXPECT_FALSE(commonViewVolume({cameraAt({1, 0, 0}, {2, 0, 0}), cameraAt({-1, 0, 0}, {-2, 0, 0})})
                   .has_value())
      << "back to back";
}

TEST(StartFromRig, IsThePartOfTheRunsVolumeThatTheCamerasSee) {
  ScenarioRun run;
  run.rig = crossedCameras();
  run.startCenter = {0.5, 0.0, 0.0};
  run.startHalfSize = {0.5, 0.1, 5.0};
  const StartVolume start = startVolumeFromRig(run);
  EXPECT_NEAR(start.center.x() - start.halfSize.x(), 0.0, 1e-12) << "the run's";
  EXPECT_NEAR(start.center.x() + start.halfSize.x(), 0.6, 0.06) << "the cameras'";
  EXPECT_NEAR(start.center.y(), 0.0, 1e-12);
  EXPECT_NEAR(start.halfSize.y(), 0.1, 1e-12);
  EXPECT_NEAR(start.halfSize.z(), 0.656, 0.06);
}

TEST(StartFromRig, IsAllThatTheCamerasSeeForAPoint) {
  ScenarioRun run;
  run.rig = crossedCameras();
  run.startCenter = {0.5, 0.0, 0.0};
  const StartVolume start = startVolumeFromRig(run);
  const auto view = commonViewVolume(run.rig);
  ASSERT_TRUE(view.has_value());
  EXPECT_EQ(start.center, view->center);
  EXPECT_EQ(start.halfSize, view->halfSize);
}

TEST(StartFromRig, IsTheRunsOwnWhereNothingIsSeen) {
  ScenarioRun run;
  run.rig = crossedCameras();
  run.startCenter = {8.0, 0.0, 0.0};
  run.startHalfSize = {1.0, 1.0, 1.0};
  EXPECT_EQ(startVolumeFromRig(run).center, run.startCenter);
  EXPECT_EQ(startVolumeFromRig(run).halfSize, run.startHalfSize);
  run.rig.pop_back();
  EXPECT_EQ(startVolumeFromRig(run).center, run.startCenter) << "one camera";
}

} // namespace
} // namespace dewpoint::tests
