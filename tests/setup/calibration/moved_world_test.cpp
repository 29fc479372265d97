// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/projector.h"
#include "core/geometry/rotation_vector.h"
#include "core/setup/calibration/moved_world.h"
#include "tests/session/fake_recording.h"

#include <gtest/gtest.h>

#include <numbers>

namespace dewpoint::tests {
namespace {

/// A quarter turn about the vertical, a shift, and half the size.
Similarity change() {
  return {0.5, geometry::rotationFromVector({0.0, 0.0, std::numbers::pi / 2.0}), {1.0, 0.0, 0.25}};
}

TEST(MovedWorld, TheImagesShowTheSamePoints) {
  const Project before = test::twoCameraProject();
  const Project after = withMovedWorld(before, change());
  const Eigen::Vector3d point(0.05, 0.1, 0.2);
  for (std::size_t k = 0; k < 2; ++k) {
    const auto seen = Projector(before.cameras[k].camera).project(point);
    const auto moved = Projector(after.cameras[k].camera).project(change() * point);
    ASSERT_TRUE(seen && moved);
    EXPECT_LT((*seen - *moved).norm(), 1e-9);
    EXPECT_TRUE(after.cameras[k].hasOwnCalibration);
  }
}

TEST(MovedWorld, WhatHasWorldCoordinatesFollows) {
  Project project = test::twoCameraProject();
  project.grid = ReferenceGrid{GridKind::Floor, {4.0, 2.0, 1.0}, 0.5, {1.0, 2.0, 0.0}, 0.1};
  project.measuredPoints = {{"nail", {1.0, 0.0, 0.5}, {}}};
  project.volumeOfInterest = WorldBox{{0.0, 0.0, 0.0}, {2.0, 1.0, 3.0}};
  PositionCorrection correction;
  correction.position = {1.0, 1.0, 0.0};
  correction.covariance = Eigen::Vector3d(4.0, 1.0, 9.0).asDiagonal();
  project.corrections = {correction};
  PersonCorrection person;
  person.position = {2.0, 0.0};
  project.personCorrections = {person};

  const Project moved = withMovedWorld(project, change());
  EXPECT_LT((moved.grid->origin - Eigen::Vector3d(0.0, 0.5, 0.25)).norm(), 1e-12);
  EXPECT_NEAR(moved.grid->rotationAngle, 0.1 + std::numbers::pi / 2.0, 1e-12);
  EXPECT_LT((moved.grid->size - Eigen::Vector3d(2.0, 1.0, 0.5)).norm(), 1e-12);
  EXPECT_DOUBLE_EQ(moved.grid->step, 0.25);
  EXPECT_LT((moved.measuredPoints[0].world - Eigen::Vector3d(1.0, 0.5, 0.5)).norm(), 1e-12);
  EXPECT_LT((moved.volumeOfInterest->min - Eigen::Vector3d(0.5, 0.0, 0.25)).norm(), 1e-12);
  EXPECT_LT((moved.volumeOfInterest->max - Eigen::Vector3d(1.0, 1.0, 1.75)).norm(), 1e-12);
  EXPECT_LT((moved.corrections[0].position - Eigen::Vector3d(0.5, 0.5, 0.25)).norm(), 1e-12);
  const Eigen::Matrix3d covariance = Eigen::Vector3d(0.25, 1.0, 2.25).asDiagonal();
  EXPECT_LT((moved.corrections[0].covariance - covariance).norm(), 1e-12);
  EXPECT_LT((*moved.personCorrections[0].position - Eigen::Vector2d(1.0, 1.0)).norm(), 1e-12);
  EXPECT_EQ(moved.targets, project.targets); // radii were measured with a ruler
}

TEST(MovedWorld, OnlyAStartThatWasGivenFollows) {
  const Project project = test::twoCameraProject(); // gives start_x, start_y and start_z
  const Project moved = withMovedWorld(project, change());
  EXPECT_NEAR(moved.parameters.at("start_x"), 1.0 + 0.5 * 0.02, 1e-12);
  EXPECT_NEAR(moved.parameters.at("start_y"), 0.5 * 0.02, 1e-12);
  EXPECT_NEAR(moved.parameters.at("start_z"), 0.25 + 0.5 * 0.1, 1e-12);
  Project open = project;
  open.parameters = ParameterValues(methodParameters(open.method));
  EXPECT_EQ(withMovedWorld(open, change()).parameters, open.parameters);
}

TEST(MovedWorld, TheAreaOfPeopleFollows) {
  Project project = test::twoCameraProject();
  project.method = "people";
  project.parameters = ParameterValues(methodParameters(project.method));
  ASSERT_TRUE(project.parameters.set("area_x", 1.0));
  ASSERT_TRUE(project.parameters.set("area_half_x", 3.0));
  const Project moved = withMovedWorld(project, change());
  EXPECT_NEAR(moved.parameters.at("area_x"), 1.0, 1e-12);
  EXPECT_NEAR(moved.parameters.at("area_y"), 0.5, 1e-12);
  EXPECT_NEAR(moved.parameters.at("area_half_y"), 1.5, 1e-12);
  EXPECT_NEAR(moved.parameters.at("floor_z"), 0.25, 1e-12);
}

} // namespace
} // namespace dewpoint::tests
