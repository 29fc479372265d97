// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/body/moving_part.h"
#include "core/simulation/body/part_shapes.h"
#include "core/simulation/body/target_volume.h"
#include "core/simulation/surface/surface_pattern.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace dewpoint::tests {
namespace {

using simulation::MovingPart;
using simulation::MovingShape;
using simulation::PartHit;
using simulation::Vector3f;

constexpr float kClose = 1e-4F;
const Vector3f kAnyColor{10.0F, 20.0F, 30.0F};

MovingPart partOf(MovingShape shape, const Vector3f& size) {
  MovingPart part;
  part.shape = shape;
  part.size = size;
  return part;
}

PartHit cast(const MovingPart& part, const Vector3f& origin, const Vector3f& direction) {
  PartHit hit;
  intersectPart(part, origin, direction.normalized(), hit);
  return hit;
}

void expectHit(const PartHit& hit, float distance, const Vector3f& normal) {
  ASSERT_NE(hit.part, nullptr);
  EXPECT_NEAR(hit.distance, distance, kClose);
  EXPECT_LT((hit.normal - normal).norm(), 10.0F * kClose) << hit.normal.transpose();
}

TEST(MovingPart, ARayMeetsAnEllipsoidWhereItsSemiAxesSay) {
  MovingPart part = partOf(MovingShape::Ellipsoid, {0.1F, 0.2F, 0.3F});
  part.center = {0.0F, 0.0F, 2.0F};
  expectHit(cast(part, Vector3f::Zero(), Vector3f::UnitZ()), 1.7F, {0.0F, 0.0F, -1.0F});
  expectHit(cast(part, {-1.0F, 0.0F, 2.0F}, Vector3f::UnitX()), 0.9F, {-1.0F, 0.0F, 0.0F});
  // Rows are the part's own axes in the world: its X axis is the world's Y.
  part.axes << 0.0F, 1.0F, 0.0F, -1.0F, 0.0F, 0.0F, 0.0F, 0.0F, 1.0F;
  expectHit(cast(part, {-1.0F, 0.0F, 2.0F}, Vector3f::UnitX()), 0.8F, {-1.0F, 0.0F, 0.0F});
}

TEST(MovingPart, ARayMeetsARodAtItsSideAndAtItsRoundEnd) {
  const MovingPart rod = partOf(MovingShape::Capsule, {0.1F, 0.1F, 0.2F});
  expectHit(cast(rod, {1.0F, 0.0F, 0.1F}, {-1.0F, 0.0F, 0.0F}), 0.9F, Vector3f::UnitX());
  // 0.05 beyond the end of the axis the ball of radius 0.1 is sqrt(0.01 - 0.0025) wide.
  const float wide = std::sqrt(0.0075F);
  expectHit(cast(rod, {1.0F, 0.0F, 0.25F}, {-1.0F, 0.0F, 0.0F}), 1.0F - wide,
            {wide / 0.1F, 0.0F, 0.5F});
  expectHit(cast(rod, {0.0F, 0.0F, 2.0F}, {0.0F, 0.0F, -1.0F}), 1.7F, Vector3f::UnitZ());
  EXPECT_EQ(cast(rod, {1.0F, 0.0F, 0.31F}, {-1.0F, 0.0F, 0.0F}).part, nullptr);
}

TEST(MovingPart, ARayMeetsAConeAtItsSideAndAtItsBase) {
  // Radius 0.1 at z = -0.1 and 0 at z = 0.1: 0.05 - z / 2.
  const MovingPart cone = partOf(MovingShape::Frustum, {0.1F, 0.0F, 0.1F});
  const Vector3f slanted = Vector3f(2.0F, 0.0F, 1.0F).normalized();
  expectHit(cast(cone, {1.0F, 0.0F, 0.0F}, {-1.0F, 0.0F, 0.0F}), 0.95F, slanted);
  expectHit(cast(cone, {0.02F, 0.0F, 1.0F}, {0.0F, 0.0F, -1.0F}), 0.94F, slanted);
  expectHit(cast(cone, {0.02F, 0.0F, -1.0F}, Vector3f::UnitZ()), 0.9F, {0.0F, 0.0F, -1.0F});
  EXPECT_EQ(cast(cone, {1.0F, 0.06F, 0.0F}, {-1.0F, 0.0F, 0.0F}).part, nullptr);
  const MovingPart cylinder = partOf(MovingShape::Frustum, {0.1F, 0.1F, 0.1F});
  expectHit(cast(cylinder, {1.0F, 0.0F, 0.05F}, {-1.0F, 0.0F, 0.0F}), 0.9F, Vector3f::UnitX());
}

TEST(MovingPart, ARayMeetsABoxOnTheSideTowardsIt) {
  const MovingPart box = partOf(MovingShape::Box, {0.1F, 0.2F, 0.3F});
  expectHit(cast(box, {0.0F, 1.0F, 0.0F}, {0.0F, -1.0F, 0.0F}), 0.8F, Vector3f::UnitY());
  EXPECT_EQ(cast(box, {0.11F, 1.0F, 0.0F}, {0.0F, -1.0F, 0.0F}).part, nullptr);
}

TEST(MovingPart, NothingBehindOrAroundTheEyeIsMet) {
  for (const MovingShape shape :
       {MovingShape::Ellipsoid, MovingShape::Capsule, MovingShape::Frustum, MovingShape::Box}) {
    const MovingPart part = partOf(shape, {0.1F, 0.1F, 0.1F});
    EXPECT_EQ(cast(part, Vector3f::Zero(), Vector3f::UnitX()).part, nullptr);
    EXPECT_EQ(cast(part, {1.0F, 0.0F, 0.0F}, Vector3f::UnitX()).part, nullptr);
    EXPECT_TRUE(contains(part, {0.05F, 0.0F, 0.02F}));
    EXPECT_FALSE(contains(part, {0.11F, 0.0F, 0.0F}));
  }
}

TEST(MovingPart, TheNearerOfTwoPartsIsSeen) {
  const MovingPart far = partOf(MovingShape::Ellipsoid, {0.1F, 0.1F, 0.1F});
  MovingPart near = far;
  near.center.x() = 0.3F;
  PartHit hit;
  intersectPart(near, {1.0F, 0.0F, 0.0F}, {-1.0F, 0.0F, 0.0F}, hit);
  intersectPart(far, {1.0F, 0.0F, 0.0F}, {-1.0F, 0.0F, 0.0F}, hit);
  EXPECT_EQ(hit.part, &near);
  EXPECT_NEAR(hit.distance, 0.6F, kClose);
}

TEST(MovingPart, VolumesAreThoseOfTheTextbook) {
  EXPECT_NEAR(volumeOf(partOf(MovingShape::Ellipsoid, {1.0F, 2.0F, 3.0F})), 8.0 * std::numbers::pi,
              1e-5);
  // A cylinder of length 0.4 and a ball, both of radius 0.1.
  EXPECT_NEAR(volumeOf(partOf(MovingShape::Capsule, {0.1F, 0.1F, 0.2F})),
              std::numbers::pi * (0.01 * 0.4 + 4.0 / 3.0 * 0.001), 1e-6);
  EXPECT_NEAR(volumeOf(partOf(MovingShape::Frustum, {0.1F, 0.0F, 0.1F})),
              std::numbers::pi / 3.0 * 0.01 * 0.2, 1e-6);
  EXPECT_NEAR(volumeOf(partOf(MovingShape::Box, {0.1F, 0.2F, 0.3F})), 0.048, 1e-6);
}

TEST(PartShapes, APartGoesFromOnePointToTheOther) {
  const Eigen::Vector3d from{0.1, 0.2, 0.3};
  const Eigen::Vector3d to{0.5, 0.2, 0.0}; // 0.5 m long
  const MovingPart cone = simulation::frustumBetween(from, 0.1, to, 0.05, kAnyColor);
  EXPECT_NEAR(cone.size.z(), 0.25F, kClose);
  const Eigen::Vector3d nearFrom = 0.95 * from + 0.05 * to; // 0.0975 wide there
  EXPECT_TRUE(contains(cone, nearFrom.cast<float>() + Vector3f(0.0F, 0.09F, 0.0F)));
  EXPECT_FALSE(contains(cone, to.cast<float>() + Vector3f(0.0F, 0.06F, 0.0F)));
  EXPECT_LT((cone.axes * cone.axes.transpose() - Eigen::Matrix3f::Identity()).norm(), kClose);
  EXPECT_NEAR(cone.axes.determinant(), 1.0F, kClose);
}

TEST(PartShapes, AMovedPartHoldsTheMovedPoints) {
  const MovingPart rod =
      simulation::capsuleBetween({0.1, 0.0, 0.0}, {0.3, 0.0, 0.0}, 0.02, kAnyColor);
  // A quarter turn about Z takes X to Y.
  Eigen::Matrix3d turn;
  turn << 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0;
  const MovingPart there = movedPart(rod, turn, {0.0, 0.0, 1.0});
  EXPECT_TRUE(contains(there, {0.0F, 0.31F, 1.0F}));
  EXPECT_TRUE(contains(there, {0.015F, 0.2F, 1.0F}));
  EXPECT_FALSE(contains(there, {0.2F, 0.0F, 1.0F}));
}

TEST(SurfacePattern, PatchesLieOverSeams) {
  simulation::SurfacePattern pattern;
  const Vector3f white{235.0F, 235.0F, 235.0F};
  const Vector3f dark{40.0F, 40.0F, 40.0F};
  pattern.patches.push_back({Vector3f::UnitX(), std::cos(0.5F), white});
  pattern.seams.push_back({Vector3f::UnitZ(), std::sin(0.1F), dark});
  const auto at = [&](float azimuth, float elevation) {
    return pattern.colorAt({std::cos(azimuth) * std::cos(elevation),
                            std::sin(azimuth) * std::cos(elevation), std::sin(elevation)},
                           kAnyColor);
  };
  EXPECT_EQ(at(0.0F, 0.0F), white);
  EXPECT_EQ(at(0.49F, 0.0F), white);
  EXPECT_EQ(at(0.51F, 0.0F), dark);
  EXPECT_EQ(at(0.51F, 0.09F), dark);
  EXPECT_EQ(at(2.0F, 0.11F), kAnyColor);
  EXPECT_EQ(at(0.0F, -0.51F), kAnyColor);
}

TEST(SurfacePattern, ARotatedPartTakesItsPatternAlong) {
  auto pattern = std::make_shared<simulation::SurfacePattern>();
  pattern->patches.push_back({Vector3f::UnitX(), 0.9F, Vector3f::Zero()});
  MovingPart part = simulation::ballPart(0.1, kAnyColor);
  part.pattern = pattern;
  EXPECT_EQ(part.colorAt(Vector3f::UnitX()), Vector3f(Vector3f::Zero()));
  Eigen::Matrix3d turn;
  turn << 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0;
  const MovingPart rotated = movedPart(part, turn, Eigen::Vector3d::Zero());
  EXPECT_EQ(rotated.colorAt(Vector3f::UnitY()), Vector3f(Vector3f::Zero()));
  EXPECT_EQ(rotated.colorAt(Vector3f::UnitX()), kAnyColor);
}

TEST(SurfacePattern, AHighlightIsWhereTheLampIsMirrored) {
  const simulation::Gloss gloss{400.0F, 20.0F};
  // Lamp and camera both straight above: mirrored at the top.
  const Vector3f down{0.0F, 0.0F, -1.0F};
  EXPECT_NEAR(gloss.highlightAt(Vector3f::UnitZ(), Vector3f::UnitZ(), down), 400.0F, 0.01F);
  const Vector3f aside{std::sin(0.3F), 0.0F, std::cos(0.3F)};
  EXPECT_NEAR(gloss.highlightAt(aside, Vector3f::UnitZ(), down),
              400.0F * std::pow(std::cos(0.3F), 20.0F), 0.1F);
}

MovingPart targetOf(MovingShape shape, const Vector3f& size) {
  MovingPart part = partOf(shape, size);
  part.belongsToTarget = true;
  return part;
}

TEST(TargetVolume, ABallIsThatOfTheTextbook) {
  MovingPart ball = simulation::ballPart(0.1, kAnyColor);
  ball.center = {1.0F, 2.0F, 3.0F};
  EXPECT_EQ(simulation::targetVolume({ball}).volume, 0.0) << "not marked";
  ball.belongsToTarget = true;
  const auto volume = simulation::targetVolume({ball});
  EXPECT_NEAR(volume.volume, 4.0 / 3.0 * std::numbers::pi * 1e-3, 1e-8);
  EXPECT_LT((volume.centroid - Eigen::Vector3d(1.0, 2.0, 3.0)).norm(), 1e-9);
  EXPECT_LT((volume.covariance - 0.002 * Eigen::Matrix3d::Identity()).norm(), 1e-8);
}

TEST(TargetVolume, AConeIsThatOfTheTextbook) {
  const auto volume =
      simulation::targetVolume({targetOf(MovingShape::Frustum, {0.1F, 0.0F, 0.1F})});
  // The centroid is a quarter of the height above the base; the variances are 3/80 height² along
  // the axis and 3/20 radius² across it: both 0.0015 m².
  EXPECT_NEAR(volume.volume, std::numbers::pi / 3.0 * 0.002, 1e-8);
  EXPECT_LT((volume.centroid - Eigen::Vector3d(0.0, 0.0, -0.05)).norm(), 1e-8);
  EXPECT_LT((volume.covariance - 0.0015 * Eigen::Matrix3d::Identity()).norm(), 1e-8);
}

TEST(TargetVolume, ARodIsNearlyItsCylinderAndABoxIsExact) {
  // Length 0.4 m without its ends of radius 1 mm: variance length² / 12.
  const auto rod = simulation::targetVolume({targetOf(MovingShape::Capsule, {0.001F, 0.0F, 0.2F})});
  EXPECT_NEAR(rod.covariance(2, 2), 0.16 / 12.0, 0.001 * 0.16);
  // A capsule without a rod is a ball.
  const auto ball = simulation::targetVolume({targetOf(MovingShape::Capsule, {0.1F, 0.0F, 0.0F})});
  EXPECT_LT((ball.covariance - 0.002 * Eigen::Matrix3d::Identity()).norm(), 1e-8);
  const auto box = simulation::targetVolume({targetOf(MovingShape::Box, {0.3F, 0.2F, 0.1F})});
  EXPECT_NEAR(box.covariance(0, 0), 0.36 / 12.0, 1e-8);
  EXPECT_NEAR(box.covariance(1, 1), 0.16 / 12.0, 1e-8);
}

TEST(TargetVolume, APartTakesItsMomentsAlong) {
  const MovingPart cone = targetOf(MovingShape::Frustum, {0.1F, 0.0F, 0.1F});
  Eigen::Matrix3d turn; // Z to X
  turn << 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, -1.0, 0.0, 0.0;
  const auto volume = simulation::targetVolume({movedPart(cone, turn, {1.0, 2.0, 3.0})});
  EXPECT_LT((volume.centroid - Eigen::Vector3d(0.95, 2.0, 3.0)).norm(), 1e-6);
  EXPECT_LT((volume.covariance - 0.0015 * Eigen::Matrix3d::Identity()).norm(), 1e-6);
}

TEST(TargetVolume, WhatTwoPartsShareCountsOnce) {
  MovingPart ball = simulation::ballPart(0.1, kAnyColor);
  ball.belongsToTarget = true;
  MovingPart other = ball;
  other.belongsToTarget = false;
  other.center.x() = 5.0F;
  const auto twice = simulation::targetVolume({ball, ball, other});
  EXPECT_NEAR(twice.volume, 4.0 / 3.0 * std::numbers::pi * 1e-3, 1e-8);
  EXPECT_LT(twice.centroid.norm(), 1e-8) << "and what is not marked does not count";
  // Two balls whose centers are a radius apart share 5/16 of one.
  other.center.x() = 0.1F;
  other.belongsToTarget = true;
  const auto both = simulation::targetVolume({ball, other});
  EXPECT_NEAR(both.volume, (2.0 - 5.0 / 16.0) * 4.0 / 3.0 * std::numbers::pi * 1e-3, 0.0001);
  EXPECT_NEAR(both.centroid.x(), 0.05, 1e-6);
}

} // namespace
} // namespace dewpoint::tests
