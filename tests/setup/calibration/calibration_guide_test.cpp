// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/calibration_guide.h"
#include "core/setup/new_project/new_project.h"
#include "tests/session/fake_recording.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

Project guessedProject() {
  Project project = test::twoCameraProject();
  for (std::size_t k = 0; k < project.cameras.size(); ++k) {
    project.cameras[k].source = SourceKind::Video;
    const Intrinsics& image = project.cameras[k].camera.intrinsics;
    guessCalibration(project, k, {image.width, image.height});
  }
  return project;
}

TEST(CalibrationGuide, EachWayEndsWithAMeasuredLength) {
  for (const CalibrationProcedure way :
       {CalibrationProcedure::Grid, CalibrationProcedure::Points, CalibrationProcedure::Board,
        CalibrationProcedure::Wand, CalibrationProcedure::File}) {
    ASSERT_FALSE(stepsOf(way).empty());
    EXPECT_EQ(stepsOf(way).back(), GuideStep::MeasuredLength);
  }
}

TEST(CalibrationGuide, LeadsFromNothingToDone) {
  Project project = guessedProject();
  const auto next = [&] {
    return nextStep(CalibrationProcedure::Board, project, calibrationStatus(project));
  };
  EXPECT_EQ(next(), GuideStep::PrintBoard);
  for (ProjectCamera& camera : project.cameras) {
    camera.camera.intrinsics.focalX += 20.0;
    camera.calibrationRecord.lens = recordOfLens(camera.camera, CalibrationOrigin::Board, 0.4);
  }
  EXPECT_EQ(next(), GuideStep::BoardInVolume);
  project.cameras[0].calibrationRecord.pose =
      recordOfPose(project.cameras[0].camera, CalibrationOrigin::Board, 0.001);
  EXPECT_EQ(next(), GuideStep::BoardInVolume); // one of two
  EXPECT_EQ(progressOf(next(), project, calibrationStatus(project)), (StepProgress{1, 2, 0.001}));
  project.cameras[1].calibrationRecord.pose =
      recordOfPose(project.cameras[1].camera, CalibrationOrigin::Board, 0.002);
  project.worldRecord.scaleOrigin = CalibrationOrigin::Board;
  EXPECT_EQ(next(), GuideStep::Floor);
  project.worldRecord.floorOrigin = CalibrationOrigin::Marks;
  EXPECT_EQ(next(), GuideStep::MeasuredLength);
  project.worldRecord.lengthCheck = LengthCheck{2.0, 2.01};
  const StepProgress length =
      progressOf(GuideStep::MeasuredLength, project, calibrationStatus(project));
  EXPECT_TRUE(length.isDone());
  EXPECT_NEAR(*length.error, 0.005, 1e-12);
  EXPECT_EQ(procedureInUse(calibrationStatus(project)), CalibrationProcedure::Board);
}

TEST(CalibrationGuide, ClicksCountPerCamera) {
  Project project = test::twoCameraProject();
  for (int k = 0; k < 4; ++k) {
    MeasuredPoint point;
    point.name = std::to_string(k);
    point.clicks = {{0, {10.0, 20.0}}};
    if (k > 0) {
      point.clicks.push_back({1, {30.0, 20.0}});
    }
    project.measuredPoints.push_back(point);
  }
  const CalibrationStatus status = calibrationStatus(project);
  EXPECT_EQ(progressOf(GuideStep::MeasurePoints, project, status), (StepProgress{1, 2, {}}));
}

TEST(CalibrationGuide, NoWayIsTakenWithoutARecord) {
  EXPECT_FALSE(procedureInUse(calibrationStatus(test::twoCameraProject())));
}

} // namespace
} // namespace dewpoint::tests
