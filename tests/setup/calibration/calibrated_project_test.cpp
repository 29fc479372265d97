// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/manual/measured_points.h"
#include "core/setup/calibration/calibrated_project.h"
#include "core/setup/new_project/new_project.h"
#include "tests/session/fake_recording.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

/// The first camera is simulated, the second one a video.
Project mixedProject() {
  Project project = test::twoCameraProject();
  project.cameras[1].source = SourceKind::Video;
  return project;
}

Camera moved(Camera camera) {
  camera.cameraFromWorld.translation().x() += 0.1;
  return camera;
}

TEST(CalibratedProject, OnlyASimulatedCameraThatChangesCountsAsAdjusted) {
  Project project = mixedProject();
  setCalibration(project.cameras[0], Camera(project.cameras[0].camera));
  EXPECT_FALSE(project.cameras[0].hasOwnCalibration);
  for (ProjectCamera& camera : project.cameras) {
    setCalibration(camera, moved(camera.camera));
  }
  EXPECT_TRUE(project.cameras[0].hasOwnCalibration);
  EXPECT_FALSE(project.cameras[1].hasOwnCalibration);
  EXPECT_EQ(project.cameras[1].camera, moved(test::twoCameras()[1]));
  setCalibration(project.cameras[0], test::twoCameras()[0]); // back where it was: still adjusted
  EXPECT_TRUE(project.cameras[0].hasOwnCalibration);
}

TEST(CalibratedProject, EveryWayToACalibrationKeepsThatRule) {
  const Project project = mixedProject();
  CameraRig rig{moved(project.cameras[0].camera), moved(project.cameras[1].camera)};
  const Project placed = withCameras(project, rig);
  std::vector<std::optional<IntrinsicsResult>> lenses(2);
  for (auto& lens : lenses) {
    lens.emplace().camera = project.cameras[0].camera;
    lens->camera.intrinsics.focalX += 1.0;
  }
  const Project seen = withIntrinsics(project, lenses);
  for (const Project& changed : {placed, seen}) {
    EXPECT_TRUE(changed.cameras[0].hasOwnCalibration);
    EXPECT_FALSE(changed.cameras[1].hasOwnCalibration);
  }
}

TEST(CalibratedProject, OffsetsAreTakenOffTheDelaysOfRealCameras) {
  Project project = mixedProject();
  project.cameras[1].delay = 0.1;
  // A camera that is another 0.02 s late has an offset of -0.02 s.
  const Project changed = withTimeOffsets(project, {-0.05, -0.02});
  EXPECT_EQ(changed.cameras[0], project.cameras[0]); // simulated: never late
  EXPECT_DOUBLE_EQ(changed.cameras[1].delay, 0.1 + 0.02);
  EXPECT_DOUBLE_EQ(withTimeOffsets(project, {0.0, 0.03}).cameras[1].delay, 0.1 - 0.03);
  EXPECT_EQ(changed.cameras[1].camera, project.cameras[1].camera);
  // Without an offset of its own a camera stays as it is.
  EXPECT_EQ(withTimeOffsets(project, {-0.05}), project);
  EXPECT_EQ(withTimeOffsets(project, {0.0, 0.0, 7.0}), project); // there is no third camera
}

TEST(CalibratedProject, ATurnedPictureTakesItsCalibrationAndClicksAlong) {
  Project project = mixedProject();
  const Camera before = project.cameras[1].camera; // 160 x 120
  project.cameras[1].rotateDegrees = 90;
  project.measuredPoints.emplace_back().name = "corner";
  setClickIn(project.measuredPoints[0], 0, {10.0, 20.0});
  setClickIn(project.measuredPoints[0], 1, {30.0, 40.0}, 12);
  const Project rotated = withImageSymmetry(project, 1, {180, false});
  EXPECT_EQ(rotated.cameras[1].rotateDegrees, 270);
  EXPECT_FALSE(rotated.cameras[1].isMirrored);
  EXPECT_EQ(rotated.cameras[0], project.cameras[0]);
  EXPECT_EQ(findClick(rotated.measuredPoints[0], 0)->pixel, Eigen::Vector2d(10.0, 20.0));
  EXPECT_EQ(findClick(rotated.measuredPoints[0], 1)->frame, 12);
  // Upside down, pixel centers at integers: 159 - 30 and 119 - 40.
  EXPECT_EQ(findClick(rotated.measuredPoints[0], 1)->pixel, Eigen::Vector2d(129.0, 79.0));
  // A point of the world moves with its pixel.
  const Eigen::Vector3d point(0.02, 0.03, 0.15);
  const auto was = Projector(before).project(point);
  const auto is = Projector(rotated.cameras[1].camera).project(point);
  ASSERT_TRUE(was && is);
  EXPECT_NEAR((*was + *is - Eigen::Vector2d(159.0, 119.0)).norm(), 0.0, 1e-9);
}

TEST(CalibratedProject, AnOrientationReplacesTheOneBefore) {
  Project project = mixedProject();
  project.cameras[1].rotateDegrees = 90;
  const Project upright = withImageOrientation(project, 1, 0, false);
  EXPECT_EQ(upright.cameras[1].rotateDegrees, 0);
  EXPECT_EQ(upright.cameras[1].camera.intrinsics.width, 120);
  EXPECT_EQ(upright.cameras[1].camera.intrinsics.height, 160);
  const Project mirrored = withImageOrientation(upright, 1, 180, true);
  EXPECT_EQ(mirrored.cameras[1].rotateDegrees, 180);
  EXPECT_TRUE(mirrored.cameras[1].isMirrored);
  EXPECT_EQ(withImageOrientation(mirrored, 1, 180, true), mirrored);
  EXPECT_EQ(withImageOrientation(project, 1, 45, false), project); // not a quarter
  guessCalibration(project, 1, {160, 120});
  const Project guessed = withImageOrientation(project, 1, 180, false);
  EXPECT_TRUE(hasGuessedLens(guessed, 1));
  EXPECT_TRUE(hasGuessedPose(guessed, 1));
  EXPECT_EQ(guessed.cameras[1].camera.intrinsics.width, 120);
}

TEST(CalibratedProject, ACroppedPictureTakesItsCalibrationAndClicksAlong) {
  Project project = mixedProject();
  const Camera before = project.cameras[1].camera; // 160 x 120
  project.measuredPoints.emplace_back().name = "corner";
  setClickIn(project.measuredPoints[0], 0, {10.0, 20.0});
  setClickIn(project.measuredPoints[0], 1, {30.0, 40.0});
  ColorSample inside;
  inside.camera = 1;
  inside.x = 80.0;
  inside.y = 60.0;
  ColorSample outside = inside;
  outside.x = 12.0;
  ColorSample other = outside;
  other.camera = 0;
  project.targets[0].samples = {inside, outside, other};
  TargetBox box;
  box.camera = 1;
  box.box = {60.0, 50.0, 20.0, 20.0};
  project.targets[0].box = box;
  project.cameras[1].calibrationRecord.lens = recordOfLens(before, CalibrationOrigin::Board);
  const ImageMargins margins{20, 10, 30, 5};
  const auto cropped = withImageCrop(project, 1, margins);
  ASSERT_TRUE(cropped) << errorSentence(cropped.error());
  EXPECT_EQ(cropped->cameras[0], project.cameras[0]);
  EXPECT_EQ(cropped->cameras[1].crop, margins);
  EXPECT_EQ(cropped->cameras[1].camera.intrinsics.width, 110);
  EXPECT_EQ(cropped->cameras[1].camera.intrinsics.height, 105);
  EXPECT_EQ(cropped->cameras[1].camera.intrinsics.centerX, before.intrinsics.centerX - 20.0);
  EXPECT_EQ(findClick(cropped->measuredPoints[0], 0)->pixel, Eigen::Vector2d(10.0, 20.0));
  EXPECT_EQ(findClick(cropped->measuredPoints[0], 1)->pixel, Eigen::Vector2d(10.0, 30.0));
  ASSERT_EQ(cropped->targets[0].samples.size(), 2U); // the one outside is gone
  EXPECT_EQ(cropped->targets[0].samples[0].x, 60.0);
  EXPECT_EQ(cropped->targets[0].samples[1], other);
  ASSERT_TRUE(cropped->targets[0].box);
  EXPECT_EQ(cropped->targets[0].box->box, (ImageBox{40.0, 40.0, 20.0, 20.0}));
  EXPECT_EQ(cropped->cameras[1].calibrationRecord.lens,
            recordOfLens(cropped->cameras[1].camera, CalibrationOrigin::Board));
  // New margins replace these.
  const auto whole = withImageCrop(*cropped, 1, {});
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->cameras[1], project.cameras[1]);
  EXPECT_EQ(whole->measuredPoints, project.measuredPoints);
  // What is rotated later takes the margins along.
  const Project rotated = withImageSymmetry(*cropped, 1, {180, false});
  EXPECT_EQ(rotated.cameras[1].crop, (ImageMargins{30, 5, 20, 10}));
}

TEST(CalibratedProject, ABoxThatIsCutOffIsRemoved) {
  Project project = mixedProject();
  TargetBox box;
  box.camera = 1;
  box.box = {140.0, 50.0, 20.0, 20.0};
  project.targets[0].box = box;
  EXPECT_TRUE(withImageCrop(project, 1, {30, 0, 0, 0})->targets[0].box);
  EXPECT_FALSE(withImageCrop(project, 1, {0, 0, 1, 0})->targets[0].box);
}

TEST(CalibratedProject, MarginsThatLeaveTooLittleAreRefused) {
  const Project project = mixedProject();
  EXPECT_TRUE(withImageCrop(project, 1, {72, 0, 72, 0}));
  EXPECT_EQ(withImageCrop(project, 1, {72, 0, 73, 0}).error().code, ErrorCode::Mismatch);
  EXPECT_EQ(withImageCrop(project, 1, {-1, 0, 0, 0}).error().code, ErrorCode::BadValue);
  EXPECT_EQ(withImageCrop(project, 0, {1, 0, 0, 0}).error().code, ErrorCode::BadValue); // simulated
}

TEST(CalibratedProject, AGuessIsGuessedAgainForTheCroppedPicture) {
  Project project = mixedProject();
  guessCalibration(project, 1, {160, 120});
  const auto cropped = withImageCrop(project, 1, {20, 0, 0, 0});
  ASSERT_TRUE(cropped);
  EXPECT_TRUE(hasGuessedLens(*cropped, 1));
  EXPECT_TRUE(hasGuessedPose(*cropped, 1));
  EXPECT_EQ(cropped->cameras[1].camera.intrinsics.width, 140);
}

TEST(CalibratedProject, ProposedSymmetriesAreSetButForSimulatedCameras) {
  Project project = mixedProject();
  project.cameras[1].rotateDegrees = 90;
  std::vector<CameraFromPoints> found(2);
  found[1].camera = 1;
  EXPECT_EQ(withProposedSymmetries(project, found), project); // nothing is proposed
  for (CameraFromPoints& camera : found) {
    camera.proposal = SymmetryProposal{.symmetry = {180, false}};
  }
  const Project changed = withProposedSymmetries(project, found);
  EXPECT_EQ(changed, withImageSymmetry(project, 1, {180, false}));
  EXPECT_EQ(changed.cameras[1].rotateDegrees, 270);
}

TEST(CalibratedProject, OnlyAFocalLengthThatWasComputedCountsAsMeasured) {
  const Project project = mixedProject();
  PointSolution solution;
  solution.rig = {project.cameras[0].camera, moved(project.cameras[1].camera)};
  CameraFromPoints& found = solution.cameras.emplace_back();
  found.camera = 1;
  found.clickCount = kFewestPointsOfFocal - 1;
  const Project kept = withPointSolution(project, solution, true);
  EXPECT_TRUE(kept.cameras[1].calibrationRecord.pose);
  EXPECT_FALSE(kept.cameras[1].calibrationRecord.lens);
  found.clickCount = kFewestPointsOfFocal;
  EXPECT_TRUE(withPointSolution(project, solution, true).cameras[1].calibrationRecord.lens);
  EXPECT_FALSE(withPointSolution(project, solution, false).cameras[1].calibrationRecord.lens);
}

TEST(CalibratedProject, AClickReplacesTheOneInTheSameCamera) {
  MeasuredPoint point;
  setClickIn(point, 2, {1.0, 2.0});
  setClickIn(point, 0, {3.0, 4.0});
  setClickIn(point, 2, {5.0, 6.0});
  ASSERT_EQ(point.clicks.size(), 2U);
  EXPECT_EQ(findClick(point, 2)->pixel, Eigen::Vector2d(5.0, 6.0));
  EXPECT_EQ(findClick(point, 1), nullptr);
}

} // namespace
} // namespace dewpoint::tests
