// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/projector.h"
#include "core/setup/clicks/clicked_position.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace dewpoint::tests {
namespace {

/// An ideal camera of 640 x 480 pixels and a focal length of 500 px.
Camera cameraAt(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const char* name) {
  Camera camera;
  camera.name = name;
  camera.intrinsics = {640, 480, 500.0, 500.0, 319.5, 239.5};
  camera.cameraFromWorld = lookAt(from, to);
  return camera;
}

const Eigen::Vector3d kTarget(0.1, -0.2, 0.3);

/// Two meters from the target, at a right angle: one looks along y, the other along x.
CameraRig rightAngle() {
  return {cameraAt(kTarget - 2.0 * Eigen::Vector3d::UnitY(), kTarget, "south"),
          cameraAt(kTarget - 2.0 * Eigen::Vector3d::UnitX(), kTarget, "west")};
}

PointClick clickOn(const CameraRig& rig, int camera, const Eigen::Vector3d& point) {
  return {camera, Projector(rig[static_cast<std::size_t>(camera)]).project(point).value()};
}

double sigmaAlong(const Gaussian3& position, const Eigen::Vector3d& direction) {
  return std::sqrt(direction.dot(position.covariance * direction));
}

// Two pixels at 2 m and 500 px are 8 mm. Across each of two rays at a right angle only the other
// one says how far; along z, across both of them, they say it twice.
TEST(ClickedPosition, OfTwoClicksIsWhereTheirRaysMeet) {
  const CameraRig rig = rightAngle();
  const auto found =
      positionFromClicks(rig, {clickOn(rig, 0, kTarget), clickOn(rig, 1, kTarget)}, std::nullopt);
  ASSERT_TRUE(found) << errorSentence(found.error());
  EXPECT_LT((found->mean - kTarget).norm(), 1e-9);
  EXPECT_NEAR(sigmaAlong(*found, Eigen::Vector3d::UnitX()), 0.008, 1e-9);
  EXPECT_NEAR(sigmaAlong(*found, Eigen::Vector3d::UnitY()), 0.008, 1e-9);
  EXPECT_NEAR(sigmaAlong(*found, Eigen::Vector3d::UnitZ()), 0.008 / std::sqrt(2.0), 1e-9);
  EXPECT_EQ(found->covariance, found->covariance.transpose());
}

// Rays that miss each other by 0.2 m: each is 0.1 m off, 12.5 standard deviations; two of them and
// one degree of freedom.
TEST(ClickedPosition, OfClicksThatDisagreeIsLessCertain) {
  const CameraRig rig = rightAngle();
  const Eigen::Vector3d up(0.0, 0.0, 0.1);
  const auto found = positionFromClicks(
      rig, {clickOn(rig, 0, kTarget + up), clickOn(rig, 1, kTarget - up)}, std::nullopt);
  ASSERT_TRUE(found) << errorSentence(found.error());
  EXPECT_LT((found->mean - kTarget).norm(), 0.01);
  const double factor = std::sqrt(2.0) * 12.5;
  EXPECT_NEAR(sigmaAlong(*found, Eigen::Vector3d::UnitX()), 0.008 * factor, 0.1 * 0.008 * factor);
}

// The estimate is 0.3 m beside the ray and 0.5 m behind the target: the point of the ray nearest to
// it, and as uncertain along the ray as it is off across.
TEST(ClickedPosition, OfOneClickTakesItsDepthFromTheEstimate) {
  const CameraRig rig = rightAngle();
  const Gaussian3 estimate{kTarget + Eigen::Vector3d(0.3, 0.5, 0.0),
                           0.04 * 0.04 * Eigen::Matrix3d::Identity()};
  const auto found = positionFromClicks(rig, {clickOn(rig, 0, kTarget)}, estimate);
  ASSERT_TRUE(found) << errorSentence(found.error());
  EXPECT_LT((found->mean - (kTarget + Eigen::Vector3d(0.0, 0.5, 0.0))).norm(), 1e-9);
  const double across = 0.01; // 2 px at 2.5 m
  EXPECT_NEAR(sigmaAlong(*found, Eigen::Vector3d::UnitX()), across, 1e-9);
  EXPECT_NEAR(sigmaAlong(*found, Eigen::Vector3d::UnitZ()), across, 1e-9);
  EXPECT_NEAR(sigmaAlong(*found, Eigen::Vector3d::UnitY()),
              std::sqrt(0.3 * 0.3 + 0.04 * 0.04 + across * across), 1e-9);
}

// Camera "west" sees 640 pixels of the ray of the middle pixel of "south": 1.28 m to either side
// of the target (320 / 500 x 2 m), depths from 0.72 to 3.28 m. Inverse depths: 1.389 and 0.305 1/m,
// in the middle 0.847, 1.181 m; of a uniform distribution over them the standard deviation is 0.313
// 1/m, at that depth 0.436 m. Depths are tried in steps of 2 %.
TEST(ClickedPosition, OfOneClickWithoutAnEstimateIsWhereOthersSee) {
  const CameraRig rig = rightAngle();
  const PointClick click = clickOn(rig, 0, kTarget);
  const Gaussian3 behind{kTarget - 5.0 * Eigen::Vector3d::UnitY(), Eigen::Matrix3d::Identity()};
  for (const auto& estimate : {std::optional<Gaussian3>(), std::optional(behind)}) {
    const auto found = positionFromClicks(rig, {click}, estimate);
    ASSERT_TRUE(found) << errorSentence(found.error());
    const double depth = (found->mean - rig[0].center()).norm();
    EXPECT_NEAR(depth, 1.181, 0.03);
    EXPECT_LT((found->mean - (rig[0].center() + depth * Eigen::Vector3d::UnitY())).norm(), 1e-9);
    EXPECT_NEAR(sigmaAlong(*found, Eigen::Vector3d::UnitY()), 0.436, 0.03);
    EXPECT_NEAR(sigmaAlong(*found, Eigen::Vector3d::UnitX()), 0.004 * depth, 1e-9);
  }
}

/// 0.4 m apart.
CameraRig sideBySide() {
  const Eigen::Vector3d ahead(0.0, 1.0, 0.0);
  const Eigen::Vector3d beside(0.4, 0.0, 0.0);
  return {cameraAt(Eigen::Vector3d::Zero(), ahead, "left"),
          cameraAt(beside, beside + ahead, "right")};
}

// The other one sees the ray from 0.4 x 500 / 320 = 0.625 m
// on and to the end of the world, which is 1.25 m in the middle of inverse depths.
TEST(ClickedPosition, OfOneClickMayLieOnAnEndlessPart) {
  const auto found = positionFromClicks(sideBySide(), {{0, {319.5, 239.5}}}, std::nullopt);
  ASSERT_TRUE(found) << errorSentence(found.error());
  EXPECT_NEAR(found->mean.y(), 1.25, 0.03);
}

TEST(ClickedPosition, WhatTheClicksLeaveOpenIsSaid) {
  CameraRig rig = rightAngle();
  const auto error = [&](const std::vector<PointClick>& clicks) {
    const auto found = positionFromClicks(rig, clicks, std::nullopt);
    EXPECT_FALSE(found);
    return found ? Error{} : found.error();
  };
  EXPECT_EQ(error({}).code, ErrorCode::BadValue);
  EXPECT_EQ(error({{2, {0.0, 0.0}}}).field, "camera");
  EXPECT_EQ(error({{-1, {0.0, 0.0}}}).field, "camera");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error({{0, {nan, 0.0}}}).field, "south");
  rig.pop_back();
  EXPECT_EQ(error({clickOn(rig, 0, kTarget)}).field, "south");
  rig = sideBySide();
  EXPECT_EQ(error({{0, {0.0, 239.5}}, {1, {639.0, 239.5}}}).field, "clicks"); // they part
}

} // namespace
} // namespace dewpoint::tests
