// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/projector.h"
#include "core/geometry/rotation_vector.h"
#include "core/project/project_rig.h"
#include "core/setup/calibration/moved_world.h"
#include "core/setup/calibration/world_step.h"
#include "tests/session/fake_recording.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

/// A point as both cameras of the project see it.
MeasuredPoint clicked(const Project& project, const std::string& name,
                      const Eigen::Vector3d& position) {
  MeasuredPoint point;
  point.name = name;
  const CameraRig rig = rigOf(project);
  for (std::size_t k = 0; k < rig.size(); ++k) {
    if (const auto pixel = Projector(rig[k]).project(position)) {
      point.clicks.push_back({static_cast<int>(k), *pixel});
    }
  }
  return point;
}

TEST(WorldStep, ClickedPointsOfTheFloorGiveTheFloor) {
  const Project right = test::twoCameraProject();
  const Similarity askew{1.0, geometry::rotationFromVector({0.4, 0.2, -0.9}), {0.1, 0.2, 0.3}};
  const Project project = withMovedWorld(right, askew);
  std::vector<MeasuredPoint> points;
  for (const Eigen::Vector3d& at :
       {Eigen::Vector3d(0.02, 0.01, 0.05), {0.09, 0.01, 0.05}, {0.02, -0.06, 0.05}}) {
    points.push_back(clicked(project, "p", askew * at));
  }
  const auto step = withWorldStep(project, WorldStep::Floor, points);
  ASSERT_TRUE(step) << step.error().detail;
  EXPECT_LT(step->floorRms, 1e-6);
  EXPECT_EQ(step->scale, 1.0);
  for (std::size_t k = 0; k < 2; ++k) {
    const Eigen::Vector3d expected =
        right.cameras[k].camera.center() - Eigen::Vector3d(0.02, 0.01, 0.05);
    EXPECT_LT((step->project.cameras[k].camera.center() - expected).norm(), 1e-6);
  }
}

TEST(WorldStep, ALengthSetsTheScale) {
  const Project project = test::twoCameraProject();
  const auto a = clicked(project, "a", {0.0, 0.0, 0.1});
  const auto b = clicked(project, "b", {0.1, 0.0, 0.1});
  const auto step = withWorldStep(project, WorldStep::Length, {a, b}, 0.2);
  ASSERT_TRUE(step) << step.error().detail;
  EXPECT_NEAR(step->scale, 2.0, 1e-6);
  EXPECT_NEAR(
      (step->project.cameras[0].camera.center() - step->project.cameras[1].camera.center()).norm(),
      2.0 * (project.cameras[0].camera.center() - project.cameras[1].camera.center()).norm(), 1e-6);
}

TEST(WorldStep, OriginLevelAndAxisTakeTheirPoints) {
  const Project project = test::twoCameraProject();
  const auto a = clicked(project, "a", {0.02, 0.0, 0.1});
  const auto b = clicked(project, "b", {0.02, 0.1, 0.11});
  const auto origin = withWorldStep(project, WorldStep::Origin, {a});
  ASSERT_TRUE(origin);
  EXPECT_LT(triangulatePoint(rigOf(origin->project), a)->mean.norm(), 1e-6);
  const auto level = withWorldStep(project, WorldStep::Level, {a, b});
  ASSERT_TRUE(level);
  EXPECT_NEAR(level->rotationAngle, std::atan(0.1), 1e-6);
  const auto axis = withWorldStep(project, WorldStep::XAxis, {a, b});
  ASSERT_TRUE(axis);
  const CameraRig rig = rigOf(axis->project);
  EXPECT_NEAR((triangulatePoint(rig, b)->mean - triangulatePoint(rig, a)->mean).y(), 0.0, 1e-6);
}

TEST(WorldStep, UprightSaysWhenThereIsNothingToDo) {
  const Project project = test::twoCameraProject();
  EXPECT_FALSE(canRotateUpright(project));
  EXPECT_EQ(withWorldStep(project, WorldStep::Upright, {}).error().field, "cameras");
  const Project under =
      withMovedWorld(project, calibration::quarterTurns(calibration::WorldAxis::X, 2));
  EXPECT_TRUE(canRotateUpright(under));
  const auto step = withWorldStep(under, WorldStep::Upright, {});
  ASSERT_TRUE(step);
  EXPECT_NEAR(step->project.cameras[0].camera.center().z(), 0.1, 1e-12);
}

TEST(WorldStep, BadPointsAreNamed) {
  const Project project = test::twoCameraProject();
  const auto good = clicked(project, "good", {0.0, 0.0, 0.1});
  auto once = good;
  once.name = "once";
  once.clicks.pop_back();
  EXPECT_EQ(withWorldStep(project, WorldStep::Origin, {once}).error().field, "once");
  EXPECT_EQ(withWorldStep(project, WorldStep::Floor, {good, good}).error().field, "points");
  EXPECT_EQ(withWorldStep(project, WorldStep::Level, {good}).error().field, "points");
  EXPECT_EQ(withWorldStep(project, WorldStep::Origin, {good, good}).error().field, "points");
  EXPECT_EQ(withWorldStep(project, WorldStep::Length, {good, good}, 1.0).error().field, "length");
}

} // namespace
} // namespace dewpoint::tests
