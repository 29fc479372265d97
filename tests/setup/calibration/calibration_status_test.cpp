// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/rotation_vector.h"
#include "core/setup/calibration/calibrated_project.h"
#include "core/setup/calibration/calibration_status.h"
#include "core/setup/calibration/moved_world.h"
#include "core/setup/new_project/new_project.h"
#include "tests/session/fake_recording.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

/// Two recorded cameras.
Project recordedProject() {
  Project project = test::twoCameraProject();
  for (ProjectCamera& camera : project.cameras) {
    camera.source = SourceKind::Video;
  }
  return project;
}

/// The same, found with a board.
Project boardProject() {
  Project project = recordedProject();
  for (ProjectCamera& camera : project.cameras) {
    camera.calibrationRecord = {recordOfLens(camera.camera, CalibrationOrigin::Board, 0.4),
                                recordOfPose(camera.camera, CalibrationOrigin::Board, 0.002)};
  }
  project.worldRecord.scaleOrigin = CalibrationOrigin::Board;
  project.worldRecord.scaleError = 0.001;
  project.worldRecord.floorOrigin = CalibrationOrigin::Board;
  project.worldRecord.errorInsideVolume = 0.003;
  project.worldRecord.errorOutsideVolume = 0.009;
  return project;
}

TEST(CalibrationStatus, GuessedCamerasAreMissing) {
  Project project = recordedProject();
  for (std::size_t k = 0; k < project.cameras.size(); ++k) {
    const Intrinsics& image = project.cameras[k].camera.intrinsics;
    guessCalibration(project, k, {image.width, image.height});
  }
  const CalibrationStatus status = calibrationStatus(project);
  ASSERT_EQ(status.cameras.size(), 2U);
  for (const CameraCalibrationStatus& camera : status.cameras) {
    EXPECT_EQ(camera.lens.knowledge, KnowledgeLevel::Missing);
    EXPECT_EQ(camera.pose.knowledge, KnowledgeLevel::Missing);
  }
  EXPECT_EQ(status.scale.knowledge, KnowledgeLevel::Missing);
  EXPECT_EQ(status.floor.knowledge, KnowledgeLevel::Missing);
}

TEST(CalibrationStatus, SimulatedCamerasAreExact) {
  const CalibrationStatus status = calibrationStatus(test::twoCameraProject());
  EXPECT_EQ(countKnownCameras(status, &CameraCalibrationStatus::pose, KnowledgeLevel::Measured),
            2U);
  EXPECT_EQ(status.scale.knowledge, KnowledgeLevel::Measured);
  EXPECT_FALSE(status.scale.origin);
}

TEST(CalibrationStatus, NumbersWithoutARecordAreGiven) {
  const CalibrationStatus status = calibrationStatus(recordedProject());
  EXPECT_EQ(countKnownCameras(status, &CameraCalibrationStatus::pose, KnowledgeLevel::Given), 2U);
  EXPECT_EQ(countKnownCameras(status, &CameraCalibrationStatus::pose, KnowledgeLevel::Measured),
            0U);
  EXPECT_EQ(status.scale.knowledge, KnowledgeLevel::Given);
  EXPECT_FALSE(status.errorInVolume);
}

TEST(CalibrationStatus, MeasuredCamerasHaveAnAccuracy) {
  const CalibrationStatus status = calibrationStatus(boardProject());
  EXPECT_EQ(countKnownCameras(status, &CameraCalibrationStatus::lens, KnowledgeLevel::Measured),
            2U);
  EXPECT_EQ(countKnownCameras(status, &CameraCalibrationStatus::pose, KnowledgeLevel::Measured),
            2U);
  EXPECT_EQ(worstError(status, &CameraCalibrationStatus::lens), 0.4);
  EXPECT_EQ(status.scale.knowledge, KnowledgeLevel::Measured);
  EXPECT_EQ(status.scale.error, 0.001);
  EXPECT_EQ(status.floor.origin, CalibrationOrigin::Board);
  EXPECT_EQ(status.errorInVolume, 0.003);
  EXPECT_EQ(status.errorOutsideVolume, 0.009);
}

TEST(CalibrationStatus, ACameraMovedByHandIsNoLongerMeasured) {
  Project project = boardProject();
  Camera moved = project.cameras[1].camera;
  moved.cameraFromWorld.translation().x() += 0.01;
  setCalibration(project.cameras[1], moved);
  const CalibrationStatus status = calibrationStatus(project);
  EXPECT_EQ(status.cameras[0].pose.knowledge, KnowledgeLevel::Measured);
  EXPECT_EQ(status.cameras[1].pose.knowledge, KnowledgeLevel::Given);
  EXPECT_EQ(status.cameras[1].lens.knowledge, KnowledgeLevel::Measured);
  EXPECT_FALSE(status.errorInVolume); // it was that of both
  EXPECT_FALSE(status.errorOutsideVolume);
}

TEST(CalibrationStatus, APoorLensIsNotDone) {
  Project project = boardProject();
  project.cameras[0].calibrationRecord.lens->error = 62.0;
  const CalibrationStatus status = calibrationStatus(project);
  EXPECT_TRUE(status.cameras[0].lens.isPoor);
  EXPECT_FALSE(status.cameras[1].lens.isPoor);
  EXPECT_EQ(countKnownCameras(status, &CameraCalibrationStatus::lens, KnowledgeLevel::Measured),
            1U);
}

TEST(CalibrationStatus, ALensAloneLeavesThePositionAGuess) {
  Project project = recordedProject();
  const Intrinsics image = project.cameras[0].camera.intrinsics;
  guessCalibration(project, 0, {image.width, image.height});
  project.cameras[0].camera.intrinsics.focalX += 20.0;
  project.cameras[0].calibrationRecord.lens =
      recordOfLens(project.cameras[0].camera, CalibrationOrigin::Board, 0.4);
  const CalibrationStatus status = calibrationStatus(project);
  EXPECT_EQ(status.cameras[0].lens.knowledge, KnowledgeLevel::Measured);
  EXPECT_EQ(status.cameras[0].pose.knowledge, KnowledgeLevel::Missing);
}

TEST(CalibrationStatus, AMoveOfAllCamerasKeepsWhatIsKnown) {
  const Similarity change{2.0, geometry::rotationFromVector({0.0, 0.0, 0.8}), {0.3, 0.2, 0.1}};
  const CalibrationStatus status = calibrationStatus(withMovedWorld(boardProject(), change));
  EXPECT_EQ(countKnownCameras(status, &CameraCalibrationStatus::pose, KnowledgeLevel::Measured),
            2U);
  EXPECT_NEAR(*worstError(status, &CameraCalibrationStatus::pose), 0.004, 1e-12);
  EXPECT_NEAR(*status.errorInVolume, 0.006, 1e-12);
  EXPECT_NEAR(*status.errorOutsideVolume, 0.018, 1e-12);
}

TEST(CalibrationStatus, ACalibrationFromAFileIsGiven) {
  const Project project = recordedProject();
  CameraRig rig;
  for (const ProjectCamera& camera : project.cameras) {
    rig.push_back(camera.camera);
  }
  const auto made = withCalibration(project, rig, "rig.toml");
  ASSERT_TRUE(made);
  const CalibrationStatus status = calibrationStatus(made->project);
  EXPECT_EQ(status.cameras[0].pose.knowledge, KnowledgeLevel::Given);
  EXPECT_EQ(status.cameras[0].pose.origin, CalibrationOrigin::File);
  EXPECT_EQ(status.scale.knowledge, KnowledgeLevel::Given);
}

TEST(CalibrationStatus, EachOriginHasAText) {
  EXPECT_STREQ(originText({}), "guessed");
  EXPECT_STREQ(originText({.knowledge = KnowledgeLevel::Measured}), "exact (simulated)");
  EXPECT_STREQ(originText({.knowledge = KnowledgeLevel::Given}), "set by hand");
  EXPECT_STREQ(
      originText({.knowledge = KnowledgeLevel::Measured, .origin = CalibrationOrigin::Board}),
      "board");
}

} // namespace
} // namespace dewpoint::tests
