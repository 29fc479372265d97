// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/rig_view.h"
#include "tests/geometry/scaled_rig.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace dewpoint::tests {
namespace {

Camera cameraAt(const std::string& name, const Eigen::Vector3d& position,
                const Eigen::Vector3d& target) {
  Camera camera;
  camera.name = name;
  camera.cameraFromWorld = lookAt(position, target);
  return camera;
}

/// Three cameras around the origin, 2 m away, all aimed at a point 1 m above it.
CameraRig threeCameras() {
  const Eigen::Vector3d target(0.0, 0.0, 1.0);
  return {cameraAt("a", {2, 0, 2}, target), cameraAt("b", {0, 2, 2}, target),
          cameraAt("c", {-2, 0, 2}, target)};
}

Camera withoutKnownPose() {
  Camera camera;
  camera.cameraFromWorld.matrix().setConstant(std::numeric_limits<double>::quiet_NaN());
  return camera;
}

TEST(RigView, ARigIsAimedAtWhereItsAxesMeet) {
  EXPECT_LT((rigAimPoint(threeCameras()) - Eigen::Vector3d(0, 0, 1)).norm(), 2e-3);
}

TEST(RigView, OneCameraIsAimedAtTwoMetersBeforeIt) {
  const CameraRig rig{cameraAt("a", {2, 0, 0}, {0, 0, 0})};
  EXPECT_LT(rigAimPoint(rig).norm(), 1e-9);
  // So are two with parallel axes: between the points before them.
  const CameraRig parallel{cameraAt("a", {2, 0, 0}, {0, 0, 0}),
                           cameraAt("b", {2, 1, 0}, {0, 1, 0})};
  EXPECT_LT((rigAimPoint(parallel) - Eigen::Vector3d(0, 0.5, 0)).norm(), 1e-9);
}

TEST(RigView, CamerasWithoutAPoseDoNotCount) {
  CameraRig rig{cameraAt("a", {2, 0, 0}, {0, 0, 0}), withoutKnownPose()};
  EXPECT_LT(rigAimPoint(rig).norm(), 1e-9);
  EXPECT_LT((rigBounds(rig).max() - Eigen::Vector3d(2, 0, 0)).norm(), 1e-9);
  rig.erase(rig.begin());
  EXPECT_EQ(rigAimPoint(rig), Eigen::Vector3d::Zero());
  EXPECT_TRUE(rigBounds(rig).isEmpty());
  EXPECT_TRUE(rigBounds({}).isEmpty());
}

TEST(RigView, TheBoxHoldsTheCamerasAndWhatTheyAreAimedAt) {
  const Eigen::AlignedBox3d box = rigBounds(threeCameras());
  EXPECT_LT((box.min() - Eigen::Vector3d(-2, 0, 1)).norm(), 2e-3);
  EXPECT_LT((box.max() - Eigen::Vector3d(2, 2, 2)).norm(), 2e-3);
}

TEST(RigView, OneCameraIsAdjusted) {
  const CameraRig before = threeCameras();
  CameraRig now = before;
  now[1].cameraFromWorld = lookAt({0.2, 2.1, 2.0}, {0.0, 0.0, 1.0});
  EXPECT_EQ(rigChange(before, now), RigChange::OneCamera);
  EXPECT_EQ(rigChange(before, before), RigChange::OneCamera);         // at most one
  now[1].cameraFromWorld = lookAt({0.0, 12.0, 2.0}, {0.0, 0.0, 1.0}); // the rig is larger now
  EXPECT_EQ(rigChange(before, now), RigChange::Elsewhere);
}

TEST(RigView, AllCamerasAreRefined) {
  const CameraRig before = threeCameras();
  EXPECT_EQ(rigChange(before, scaled(before, 1.05)), RigChange::Refined);
  EXPECT_EQ(rigChange(before, scaled(before, 1.5)), RigChange::Elsewhere);
  EXPECT_EQ(rigChange(before, scaled(before, 0.5)), RigChange::Elsewhere);
  CameraRig shifted = before;
  for (Camera& camera : shifted) {
    camera.cameraFromWorld = camera.cameraFromWorld * Eigen::Translation3d(0.0, 3.0, 0.0);
  }
  EXPECT_EQ(rigChange(before, shifted), RigChange::Elsewhere);
}

TEST(RigView, OtherCamerasAreElsewhere) {
  const CameraRig before = threeCameras();
  CameraRig now = before;
  now[0].name = "another";
  EXPECT_EQ(rigChange(before, now), RigChange::Elsewhere);
  now = before;
  now.pop_back();
  EXPECT_EQ(rigChange(before, now), RigChange::Elsewhere);
  EXPECT_EQ(rigChange({}, before), RigChange::Elsewhere);
  EXPECT_EQ(rigChange(before, {}), RigChange::Elsewhere);
}

} // namespace
} // namespace dewpoint::tests
