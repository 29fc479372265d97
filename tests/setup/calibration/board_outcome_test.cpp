// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of a project with an outcome; how one is found is in board_calibration_test.cpp.
#include "core/setup/calibration/board_outcome.h"
#include "tests/session/fake_recording.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

/// A lens for the first camera only, 1 px longer than its own.
LensesFromBoards lensOfTheFirst(const Project& project) {
  LensesFromBoards lenses;
  lenses.cameras.resize(2);
  IntrinsicsResult& lens = lenses.cameras[0].emplace();
  lens.camera = project.cameras[0].camera;
  lens.camera.intrinsics.focalX += 1.0;
  lens.camera.cameraFromWorld.setIdentity(); // a lens says nothing about the pose
  return lenses;
}

/// Both cameras 0.1 m farther to the side.
ExtrinsicsResult movedCameras(const Project& project) {
  ExtrinsicsResult extrinsics;
  for (const ProjectCamera& camera : project.cameras) {
    extrinsics.cameras.push_back(camera.camera);
    extrinsics.cameras.back().cameraFromWorld.translation().x() += 0.1;
  }
  return extrinsics;
}

TEST(BoardOutcome, OnlyAFaultMakesItDoubtful) {
  BoardOutcome outcome;
  EXPECT_FALSE(isDoubtful(outcome)); // lenses only: no faults are looked for
  outcome.extrinsicsError = Error{ErrorCode::Undetermined, "", "cameras", ""};
  EXPECT_FALSE(isDoubtful(outcome));
  outcome.extrinsics.emplace().notices = {"'door' never saw the board: it keeps its pose"};
  EXPECT_FALSE(isDoubtful(outcome)); // a notice is no fault
  outcome.extrinsics->faults = {{.fault = CalibrationFault::WrongUnitMillimeters}};
  EXPECT_TRUE(isDoubtful(outcome));
}

TEST(BoardOutcome, NothingFoundChangesNothing) {
  const Project project = test::twoCameraProject();
  EXPECT_EQ(withOutcome(project, BoardOutcome{}), project);
}

TEST(BoardOutcome, LensesLeaveThePosesAndTheOtherCameras) {
  const Project project = test::twoCameraProject();
  BoardOutcome outcome;
  outcome.lenses = lensOfTheFirst(project);
  const Project changed = withOutcome(project, outcome);
  const Camera& first = changed.cameras[0].camera;
  EXPECT_EQ(first.intrinsics.focalX, 151.0); // 150 of twoCameras(), and the 1 px more
  EXPECT_EQ(first.cameraFromWorld.matrix(), project.cameras[0].camera.cameraFromWorld.matrix());
  EXPECT_EQ(changed.cameras[1], project.cameras[1]);
}

TEST(BoardOutcome, ThePosesWereFoundWithTheLensesAndCountLast) {
  const Project project = test::twoCameraProject();
  BoardOutcome outcome;
  outcome.lenses = lensOfTheFirst(project);
  outcome.extrinsics = movedCameras(project);
  outcome.extrinsics->cameras[0].intrinsics.focalX = 152.0; // adjusted with the poses
  const Project changed = withOutcome(project, outcome);
  EXPECT_EQ(changed.cameras[0].camera, outcome.extrinsics->cameras[0]);
  EXPECT_EQ(changed.cameras[1].camera, outcome.extrinsics->cameras[1]);
}

TEST(BoardOutcome, WhatElseWasChangedMeanwhileStays) {
  Project project = test::twoCameraProject();
  BoardOutcome outcome;
  outcome.project = project; // as it was when the calibration began
  outcome.extrinsics = movedCameras(project);
  project.name = "renamed";
  project.targets.clear();
  const Project changed = withOutcome(project, outcome);
  EXPECT_EQ(changed.name, "renamed");
  EXPECT_TRUE(changed.targets.empty());
  EXPECT_EQ(changed.cameras[1].camera, outcome.extrinsics->cameras[1]);
}

} // namespace
} // namespace dewpoint::tests
