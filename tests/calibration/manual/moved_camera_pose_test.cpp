// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"
#include "core/calibration/manual/moved_camera_pose.h"
#include "core/geometry/projector.h"
#include "core/geometry/rotation_vector.h"

#include <gtest/gtest.h>

#include <numbers>

namespace dewpoint::tests {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

Camera camera() {
  Camera result;
  result.name = "left";
  result.intrinsics = {640, 480, 500.0, 500.0, 319.5, 239.5};
  result.distortion = {-0.1, 0.02, 0.001, -0.001};
  result.cameraFromWorld = lookAt({3.0, -1.0, 1.8}, {0.0, 0.0, 0.5});
  return result;
}

/// A target on its way through a box of 1.6 m, seen with noise; `wild` of them somewhere else.
std::vector<PointSighting> sightings(const Camera& seenBy, int count, double noise, int wild = 0) {
  const RandomStream random(5, 0, 0, RandomPurpose::Noise);
  const Projector projector(seenBy);
  std::vector<PointSighting> list;
  for (int i = 0; i < count; ++i) {
    const auto place = random.uniform3(std::uint32_t(i));
    const auto error = random.normal4(std::uint32_t(i), 7);
    const Eigen::Vector3d world(1.6 * place[0] - 0.8, 1.6 * place[1] - 0.8, place[2]);
    Eigen::Vector2d pixel = *projector.project(world) + noise * Eigen::Vector2d(error[0], error[1]);
    if (i < wild) {
      pixel += Eigen::Vector2d(90.0, -60.0);
    }
    list.push_back({world, pixel, noise});
  }
  return list;
}

double angleBetween(const Camera& a, const Camera& b) {
  return vectorFromRotation(a.cameraFromWorld.linear() * b.cameraFromWorld.linear().transpose())
      .norm();
}

TEST(EstimateMovedPose, WithoutSightingsTurnsTheCamera) {
  const Eigen::Vector3d turn(0.01, -0.02, 0.005);
  const auto moved = estimateMovedPose(camera(), {.turn = turn}, {});
  ASSERT_TRUE(moved) << errorSentence(moved.error());
  EXPECT_LT(angleBetween(moved->camera, rotatedCamera(camera(), turn)), 1e-9);
  EXPECT_LT((moved->camera.center() - camera().center()).norm(), 1e-9);
}

TEST(EstimateMovedPose, FindsTurnAndShiftFromTheTarget) {
  Camera bumped = rotatedCamera(camera(), Eigen::Vector3d(0.5, -0.8, 0.3) * kDegree);
  bumped.cameraFromWorld.translation() += Eigen::Vector3d(0.004, -0.003, 0.002);
  // The background gives the turn to 0.05 degrees.
  const CameraMotionPrior prior{.turn = Eigen::Vector3d(0.52, -0.75, 0.33) * kDegree};
  const auto seen = sightings(bumped, 300, 0.5);
  const auto moved = estimateMovedPose(camera(), prior, seen);
  ASSERT_TRUE(moved) << errorSentence(moved.error());
  EXPECT_GT(moved->medianResidualPxBefore, 4.0); // 0.94 degrees at 500 px are 8 px
  EXPECT_LT(moved->medianResidualPxAfter, 0.7);  // the median of a Rayleigh of 0.5 px is 0.59
  EXPECT_LT(angleBetween(moved->camera, bumped), 0.05 * kDegree);
  EXPECT_LT((moved->camera.center() - bumped.center()).norm(), 0.003);
  // What is left is what is said to be left: within four sigma.
  const Eigen::Vector3d off =
      bumped.cameraFromWorld.linear() * (moved->camera.center() - bumped.center());
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_LT(std::abs(off[axis]), 4.0 * moved->shiftSigma[axis]);
  }
}

TEST(EstimateMovedPose, IsNotFooledByWrongSightings) {
  const Camera bumped = rotatedCamera(camera(), Eigen::Vector3d(0.1, 0.2, 0.0) * kDegree);
  const auto seen = sightings(bumped, 200, 0.5, 40);
  const auto moved =
      estimateMovedPose(camera(), {.turn = Eigen::Vector3d(0.1, 0.2, 0.0) * kDegree}, seen);
  ASSERT_TRUE(moved) << errorSentence(moved.error());
  EXPECT_LT(angleBetween(moved->camera, bumped), 0.05 * kDegree);
  EXPECT_LE(moved->usedSightingCount, 160);
}

TEST(EstimateMovedPose, SaysWhenNoPoseNearbyFits) {
  Camera elsewhere = camera();
  elsewhere.cameraFromWorld = lookAt({-2.0, 2.5, 1.0}, {0.0, 0.0, 0.5});
  const auto moved = estimateMovedPose(camera(), {}, sightings(elsewhere, 100, 0.5));
  ASSERT_FALSE(moved);
  EXPECT_EQ(moved.error().field, "left");
}

} // namespace
} // namespace dewpoint::tests
