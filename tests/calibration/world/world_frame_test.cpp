// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/angle.h"
#include "core/calibration/world/world_frame.h"
#include "core/geometry/rotation_vector.h"

#include <gtest/gtest.h>

#include <numbers>

namespace dewpoint::tests {
namespace {

using calibration::WorldAxis;

Camera cameraAt(const Eigen::Vector3d& position, const Eigen::Vector3d& target, double roll = 0.0) {
  Camera camera;
  camera.cameraFromWorld = lookAt(position, target, Eigen::Vector3d::UnitZ(), roll);
  return camera;
}

/// Four cameras above the corners of a room that look down a little.
CameraRig corners(double roll = 0.0) {
  CameraRig rig;
  for (const double x : {-2.0, 2.0}) {
    for (const double y : {-2.0, 2.0}) {
      rig.push_back(cameraAt({x, y, 2.2}, {0.0, 0.0, 0.8}, roll));
    }
  }
  return rig;
}

CameraRig moved(const Similarity& change, CameraRig rig) {
  for (Camera& camera : rig) {
    camera = transformed(change, camera);
  }
  return rig;
}

/// A world that stands askew.
Similarity askew() {
  return {1.0, geometry::rotationFromVector({2.0, -0.7, 0.4}), {0.3, 0.2, -1.1}};
}

TEST(WorldFrame, ThreePointsOfTheFloorSetOriginAxesAndUp) {
  const Eigen::Vector3d a(0.5, 0.25, 0.0), b(1.5, 0.25, 0.0), c(0.2, -1.0, 0.0);
  const CameraRig rig = moved(askew(), corners());
  const auto floor = calibration::changeToFloor({askew() * a, askew() * b, askew() * c}, rig);
  ASSERT_TRUE(floor);
  EXPECT_NEAR(floor->rmsDistance, 0.0, 1e-9);
  EXPECT_EQ(floor->change.scale, 1.0);
  const Similarity whole = floor->change * askew();
  EXPECT_LT((whole * a).norm(), 1e-9);
  EXPECT_LT((whole * b - Eigen::Vector3d(1.0, 0.0, 0.0)).norm(), 1e-9);
  EXPECT_LT((whole * c - Eigen::Vector3d(-0.3, -1.25, 0.0)).norm(), 1e-9);
  for (const Camera& camera : moved(floor->change, rig)) {
    EXPECT_NEAR(camera.center().z(), 2.2, 1e-9); // above the floor, not below
  }
}

TEST(WorldFrame, MoreThanThreePointsGiveTheFloorThatFitsAllOfThem) {
  const std::vector<Eigen::Vector3d> points{
      {0.0, 0.0, 0.003}, {2.0, 0.0, -0.003}, {2.0, 2.0, 0.003}, {0.0, 2.0, -0.003}};
  const auto floor = calibration::changeToFloor(points, corners());
  ASSERT_TRUE(floor);
  EXPECT_NEAR(floor->rmsDistance, 0.003, 1e-9);
  EXPECT_LT(geometry::angleBetween(floor->change.rotation, Eigen::Matrix3d::Identity()), 1e-3);
}

TEST(WorldFrame, PointsOnALineAreNoFloor) {
  const auto floor =
      calibration::changeToFloor({{0.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {2.0, 2.0, 0.001}}, corners());
  ASSERT_FALSE(floor);
  EXPECT_EQ(floor.error().field, "floor");
  EXPECT_FALSE(calibration::changeToFloor({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, corners()));
}

TEST(WorldFrame, ALevelLineTakesOutTheTiltAlongIt) {
  const Eigen::Vector3d from(1.0, 2.0, 0.5);
  const Eigen::Vector3d to(2.0, 2.0, 0.6);
  const auto level = calibration::levelingRotation(from, to);
  ASSERT_TRUE(level);
  EXPECT_LT((*level * from - from).norm(), 1e-12);
  EXPECT_NEAR((*level * to).z(), 0.5, 1e-12);
  EXPECT_NEAR((*level * to).y(), 2.0, 1e-12);
  EXPECT_NEAR(geometry::vectorFromRotation(level->rotation).norm(), std::atan(0.1), 1e-12);
  EXPECT_FALSE(calibration::levelingRotation(from, from));
  EXPECT_FALSE(calibration::levelingRotation(from, {1.1, 2.0, 2.0}));
}

TEST(WorldFrame, OriginAndXAxisGoWhereTheyAreWanted) {
  const Eigen::Vector3d point(1.0, -2.0, 0.5);
  EXPECT_EQ(calibration::changeToOrigin(point) * point, Eigen::Vector3d::Zero());
  const auto axis = calibration::changeToXAxis({1.0, 1.0, 0.2}, {1.0, 3.0, 0.7});
  ASSERT_TRUE(axis);
  const Eigen::Vector3d along = axis->rotation * Eigen::Vector3d(0.0, 2.0, 0.5);
  EXPECT_LT((along - Eigen::Vector3d(2.0, 0.0, 0.5)).norm(), 1e-12);
  EXPECT_FALSE(calibration::changeToXAxis({1.0, 1.0, 0.2}, {1.0, 1.0, 0.9}));
}

TEST(WorldFrame, AMeasuredLengthScalesTheWorld) {
  const Eigen::Vector3d a(1.0, 0.0, 0.0), b(1.0, 0.0, 3.0);
  const auto scaled = calibration::scaleToLength(a, b, 1.5);
  ASSERT_TRUE(scaled);
  EXPECT_DOUBLE_EQ(scaled->scale, 0.5);
  EXPECT_NEAR((*scaled * a - *scaled * b).norm(), 1.5, 1e-12);
  EXPECT_EQ(*scaled * Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
  for (const double wrong : {0.0, -1.0, std::nan("")}) {
    EXPECT_FALSE(calibration::scaleToLength(a, b, wrong)) << wrong;
  }
  EXPECT_FALSE(calibration::scaleToLength(a, a, 1.0));
}

TEST(WorldFrame, QuarterTurnsAreExact) {
  const Eigen::Vector3d point(1.0, 2.0, 3.0);
  EXPECT_EQ(calibration::quarterTurns(WorldAxis::Z, 1) * point, Eigen::Vector3d(-2.0, 1.0, 3.0));
  EXPECT_EQ(calibration::quarterTurns(WorldAxis::X, 1) * point, Eigen::Vector3d(1.0, -3.0, 2.0));
  EXPECT_EQ(calibration::quarterTurns(WorldAxis::Y, -1) * point, Eigen::Vector3d(-3.0, 2.0, 1.0));
  EXPECT_EQ(calibration::quarterTurns(WorldAxis::Y, 4) * point, point);
}

TEST(WorldFrame, AllCamerasMoveTogether) {
  const Similarity change = calibration::rigidMotion({1.0, 0.0, -0.5}, std::numbers::pi / 2.0);
  EXPECT_LT((change * Eigen::Vector3d(2.0, 0.0, 1.0) - Eigen::Vector3d(1.0, 2.0, 0.5)).norm(),
            1e-12);
}

TEST(WorldFrame, AnUpsideDownWorldIsTurned) {
  EXPECT_FALSE(calibration::uprightRotation(corners()));
  for (const WorldAxis axis : {WorldAxis::X, WorldAxis::Y}) {
    const CameraRig under = moved(calibration::quarterTurns(axis, 2), corners());
    const auto turn = calibration::uprightRotation(under);
    ASSERT_TRUE(turn);
    for (const Camera& camera : moved(*turn, under)) {
      EXPECT_NEAR(camera.center().z(), 2.2, 1e-12);
    }
  }
}

TEST(WorldFrame, TheAxesOfAFirstCameraAreTurnedUpright) {
  const CameraRig rig = corners();
  Similarity toFirst;
  toFirst.rotation = rig[0].cameraFromWorld.linear();
  toFirst.translation = rig[0].cameraFromWorld.translation();
  const auto turn = calibration::uprightRotation(moved(toFirst, rig));
  ASSERT_TRUE(turn);
  // The first camera looks down by about 26 degrees, and so z is that far from up.
  const Eigen::Vector3d up = (*turn * toFirst).rotation * Eigen::Vector3d::UnitZ();
  EXPECT_GT(up.z(), std::cos(30.0 * base::kDegree));
  EXPECT_FALSE(calibration::uprightRotation(moved(*turn * toFirst, rig)));
}

TEST(WorldFrame, CamerasUnderACeilingMayHangUpsideDown) {
  EXPECT_FALSE(calibration::uprightRotation(corners(std::numbers::pi)));
}

TEST(WorldFrame, CamerasThatLookStraightDownDoNotShowWhichWayIsUp) {
  EXPECT_FALSE(calibration::uprightRotation(
      {cameraAt({0.0, 0.0, 2.0}, {0.0, 0.0, 0.0}), cameraAt({1.0, 0.0, 2.0}, {1.0, 0.0, 0.0})}));
  EXPECT_FALSE(calibration::uprightRotation({}));
}

} // namespace
} // namespace dewpoint::tests
