// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_check.h"
#include "core/setup/new_project/new_project.h"
#include "core/setup/new_project/project_cameras.h"
#include "core/tracking/catalog/method_catalog.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include <filesystem>

namespace dewpoint::tests {
namespace {

namespace fs = std::filesystem;

/// A project of three cameras with test patterns, of which nobody has calibrated any.
Project threePatterns() {
  NewProject wanted;
  wanted.cameras = {{"", SourceKind::Stream, "test:ball"},
                    {"", SourceKind::Stream, "test:smpte"},
                    {"", SourceKind::Stream, "test:snow"}};
  const auto made = createNewProject(wanted);
  EXPECT_TRUE(made);
  return made->project;
}

/// Calibrated: neither lens nor pose is the guessed one.
void calibrate(Project& project, std::size_t camera) {
  Camera& changed = project.cameras[camera].camera;
  changed.intrinsics.focalX += 50.0;
  changed.cameraFromWorld.translation().z() += 0.5;
}

/// Marks something in the images of each camera.
void clickInAll(Project& project) {
  MeasuredPoint point;
  point.name = "corner";
  PositionCorrection correction;
  Target target;
  target.name = "ball";
  target.color = {0.0, 40.0, 0.2, 1.0, 0.1, 1.0};
  for (int k = 0; k < 3; ++k) {
    const double pixel = 100.0 + k;
    point.clicks.push_back({k, {pixel, pixel}});
    correction.clicks.push_back({k, {pixel, pixel}});
    ColorSample& sample = target.samples.emplace_back();
    sample.camera = k;
    sample.x = pixel;
    PersonCorrection& person = project.personCorrections.emplace_back();
    person.click = {k, {pixel, pixel}};
  }
  project.measuredPoints = {point};
  project.corrections = {correction};
  project.targets = {target};
  target.name = "cup";
  target.samples.clear();
  target.box = TargetBox{2, 0, {10.0, 10.0, 20.0, 20.0}};
  project.targets.push_back(target);
}

TEST(ProjectCameras, WhatWasMarkedFollowsItsCamera) {
  Project project = threePatterns();
  clickInAll(project);
  ASSERT_TRUE(removeProjectCamera(project, 1));
  ASSERT_EQ(project.cameras.size(), 2U);
  EXPECT_EQ(project.cameras[1].location, "test:snow");
  const auto isOfFirstAndLast = [](const auto& items) {
    return items.size() == 2 && items[0].camera == 0 && items[1].camera == 1;
  };
  EXPECT_TRUE(isOfFirstAndLast(project.measuredPoints[0].clicks));
  EXPECT_DOUBLE_EQ(project.measuredPoints[0].clicks[1].pixel.x(), 102.0);
  EXPECT_TRUE(isOfFirstAndLast(project.corrections[0].clicks));
  EXPECT_TRUE(isOfFirstAndLast(project.targets[0].samples));
  EXPECT_DOUBLE_EQ(project.targets[0].samples[1].x, 102.0);
  ASSERT_EQ(project.personCorrections.size(), 2U);
  EXPECT_EQ(project.personCorrections[1].click->camera, 1);
  ASSERT_TRUE(project.targets[1].box);
  EXPECT_EQ(project.targets[1].box->camera, 1);
  ASSERT_TRUE(removeProjectCamera(project, 1));
  EXPECT_FALSE(project.targets[1].box);
  const auto good = checkProject(project);
  EXPECT_TRUE(good) << errorSentence(good.error());
}

TEST(ProjectCameras, TheLastCameraStays) {
  Project project = threePatterns();
  ASSERT_TRUE(removeProjectCamera(project, 2));
  ASSERT_TRUE(removeProjectCamera(project, 0));
  const Project before = project;
  const auto refused = removeProjectCamera(project, 0);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::MissingKey);
  EXPECT_EQ(project, before);
}

TEST(ProjectCameras, GuessesStayGuessesAndCalibrationsStay) {
  Project project = threePatterns();
  calibrate(project, 1);
  const Camera known = project.cameras[1].camera;
  ASSERT_TRUE(addCameras(project, {{"", SourceKind::Stream, "test:gamut", {}, {}},
                                   {"", SourceKind::Stream, "test:blink", {320, 240}, {}}}));
  ASSERT_EQ(project.cameras.size(), 5U);
  EXPECT_EQ(project.cameras[1].camera, known);
  for (const std::size_t guessed : {0U, 2U, 3U, 4U}) {
    EXPECT_TRUE(hasGuessedPose(project, guessed)) << guessed;
    EXPECT_TRUE(hasGuessedLens(project, guessed)) << guessed;
  }
  EXPECT_EQ(project.cameras[3].camera.intrinsics.width, kAssumedImageWidth);
  EXPECT_EQ(project.cameras[4].camera.intrinsics.width, 320);
  EXPECT_EQ(project.cameras[4].camera.intrinsics.height, 240);
  ASSERT_TRUE(removeProjectCamera(project, 0));
  EXPECT_EQ(project.cameras[0].camera, known);
  EXPECT_FALSE(hasGuessedPose(project, 0));
  EXPECT_TRUE(hasGuessedPose(project, 1));
  EXPECT_TRUE(hasGuessedPose(project, 3));
}

TEST(ProjectCameras, NamesOfAddedCamerasAreNew) {
  Project project = threePatterns();
  ASSERT_TRUE(addCameras(project, {{"camera 2", SourceKind::Stream, "test:gamut", {}, {}},
                                   {"", SourceKind::Stream, "test:blink", {}, {}},
                                   {"door", SourceKind::Device, "/dev/video3", {}, {}}}));
  EXPECT_EQ(project.cameras[3].camera.name, "camera 2 2");
  EXPECT_EQ(project.cameras[4].camera.name, "camera 5");
  EXPECT_EQ(project.cameras[5].camera.name, "door");
}

TEST(ProjectCameras, RecordingsAndLiveCamerasAreNotMixed) {
  Project project = threePatterns();
  const Project before = project;
  const auto refused = addCameras(project, {{"", SourceKind::Video, "/tmp/a.mkv", {64, 48}, {}}});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::Mismatch);
  EXPECT_EQ(project, before);
  EXPECT_FALSE(replaceSource(project, 0, {"", SourceKind::Video, "/tmp/a.mkv", {640, 480}, {}}));
  EXPECT_EQ(project, before);
  project.scene = "demo";
  EXPECT_FALSE(checkCanAddCamera(project, SourceKind::Stream));
}

TEST(ProjectCameras, AReplacedSourceKeepsNameAndCalibration) {
  Project project = threePatterns();
  calibrate(project, 0);
  const Camera known = project.cameras[0].camera;
  ASSERT_TRUE(replaceSource(project, 0, {"other", SourceKind::Device, "/dev/video7", {}, {}}));
  EXPECT_EQ(project.cameras[0].camera, known);
  EXPECT_EQ(project.cameras[0].source, SourceKind::Device);
  EXPECT_EQ(project.cameras[0].location, "/dev/video7");
  // A guess takes the new size.
  ASSERT_TRUE(replaceSource(project, 1, {"", SourceKind::Stream, "test:blink", {1280, 720}, {}}));
  EXPECT_EQ(project.cameras[1].camera.intrinsics.width, 1280);
  EXPECT_TRUE(hasGuessedPose(project, 1));
}

TEST(ProjectCameras, AReplacedSourceIsCroppedAsBefore) {
  Project project = threePatterns();
  const Intrinsics lens = project.cameras[1].camera.intrinsics;
  project.cameras[1].crop = {10, 0, 30, 20};
  ASSERT_TRUE(replaceSource(project, 1, {"", SourceKind::Stream, "test:blink", {1280, 720}, {}}));
  EXPECT_EQ(project.cameras[1].camera.intrinsics.width, 1240);
  EXPECT_EQ(project.cameras[1].camera.intrinsics.height, 700);
  const auto refused =
      replaceSource(project, 1, {"", SourceKind::Stream, "test:snow?width=32", {32, 480}, {}});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::Mismatch);
  EXPECT_NE(project.cameras[1].camera.intrinsics, lens);
}

TEST(ProjectCameras, ASourceOfAnotherCameraIsExchanged) {
  Project project = threePatterns();
  project.cameras[0].rotateDegrees = 180; // of the place, not of the device
  ASSERT_TRUE(replaceSource(project, 0, {"", SourceKind::Stream, "test:snow", {}, {}}));
  EXPECT_EQ(project.cameras[0].location, "test:snow");
  EXPECT_EQ(project.cameras[2].location, "test:ball");
  EXPECT_EQ(project.cameras[0].rotateDegrees, 180);
  EXPECT_EQ(project.cameras[2].rotateDegrees, 0);
}

TEST(ProjectCameras, ADeviceIsTheSameWhereverItIsPluggedIn) {
  Project project = threePatterns();
  const auto device = [](const std::string& path, const std::string& serial) {
    CameraSource source{"", SourceKind::Device, path, {}, {}};
    source.device.identity = {"", serial, "Webcam", "046d:082d"};
    return source;
  };
  ASSERT_TRUE(replaceSource(project, 0, device("/dev/video0", "A")));
  ASSERT_TRUE(replaceSource(project, 1, device("/dev/video2", "B")));
  project.cameras[0].device.controls = {{"gain", 7}};
  // After a restart they have other numbers, and the user finds them exchanged.
  ASSERT_TRUE(replaceSource(project, 1, device("/dev/video4", "A")));
  EXPECT_EQ(project.cameras[0].device.identity.serial, "B");
  EXPECT_EQ(project.cameras[1].device.identity.serial, "A");
  EXPECT_EQ(project.cameras[1].device.controls.count("gain"), 1U);
  // What is plugged in where another one was before is not that one.
  ASSERT_TRUE(replaceSource(project, 2, device(project.cameras[0].location, "C")));
  EXPECT_EQ(project.cameras[0].device.identity.serial, "B");
  EXPECT_EQ(project.cameras[2].device.identity.serial, "C");
  // A new device of the same model takes over what was set.
  ASSERT_TRUE(replaceSource(project, 1, device("/dev/video8", "D")));
  EXPECT_EQ(project.cameras[1].device.identity.serial, "D");
  EXPECT_EQ(project.cameras[1].device.controls.count("gain"), 1U);
}

TEST(ProjectCameras, RecordingsSayTheirSize) {
  const fs::path folder = fs::path(testing::TempDir()) / "project_cameras" / "left";
  fs::create_directories(folder);
  cv::imwrite((folder / "0.png").string(), cv::Mat(48, 64, CV_8UC3, cv::Scalar(0)));
  const auto source = sourceAt(folder.string() + "/");
  ASSERT_TRUE(source) << errorSentence(source.error());
  EXPECT_EQ(source->kind, SourceKind::Images);
  EXPECT_EQ(source->location, folder.string());
  EXPECT_EQ(source->size, cv::Size(64, 48));
  EXPECT_EQ(sourceAt((folder / "none.mkv").string()).error().code, ErrorCode::FileMissing);
  EXPECT_EQ(sourceAt("").error().code, ErrorCode::BadValue);
  EXPECT_EQ(sourceAt("test:no-such-pattern").error().code, ErrorCode::BadValue);
  const auto live = sourceAt("rtsp://10.0.0.9/door", "door");
  ASSERT_TRUE(live);
  EXPECT_EQ(live->kind, SourceKind::Stream);
  EXPECT_TRUE(live->size.empty());

  Project project;
  ASSERT_TRUE(addCameras(project, {*source, *source}));
  EXPECT_EQ(project.cameras[0].camera.name, "left");
  EXPECT_EQ(project.cameras[1].camera.name, "left 2");
  // A calibrated camera accepts recordings of its size only.
  calibrate(project, 0);
  const auto refused =
      replaceSource(project, 0, {"", SourceKind::Video, "/tmp/b.mkv", {32, 32}, {}});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::Mismatch);
}

} // namespace
} // namespace dewpoint::tests
