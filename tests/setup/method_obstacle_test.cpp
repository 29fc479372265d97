// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/setup/method_obstacle.h"
#include "core/setup/new_project/new_project.h"
#include "core/tracking/catalog/method_catalog.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include <filesystem>
#include <string>

namespace dewpoint::tests {
namespace {

namespace fs = std::filesystem;

/// A new project of so many cameras without a calibration: where they stand is a guess.
Project guessed(std::size_t count) {
  NewProject wanted;
  // Not the folder of another test, which may run at the same time.
  const fs::path root = fs::path(testing::TempDir()) / "obstacles" /
                        testing::UnitTest::GetInstance()->current_test_info()->name();
  for (std::size_t k = 0; k < count; ++k) {
    const fs::path folder = root / std::to_string(k);
    fs::create_directories(folder);
    cv::imwrite((folder / "0.png").string(), cv::Mat(48, 64, CV_8UC3, cv::Scalar(0)));
    wanted.cameras.push_back({"", SourceKind::Images, folder.string()});
  }
  return createNewProject(wanted)->project;
}

Project calibrated(std::size_t count) {
  Project project = guessed(count);
  for (ProjectCamera& camera : project.cameras) {
    camera.camera.cameraFromWorld.translation().z() += 0.5;
  }
  return project;
}

MethodObstacle obstacle(const Project& project, const char* method) {
  return methodObstacle(project, *findMethod(method));
}

TEST(MethodObstacle, NoneWithCalibratedCameras) {
  const Project project = calibrated(2);
  for (const Method& method : methods()) {
    EXPECT_EQ(methodObstacle(project, method), MethodObstacle::None) << method.name;
  }
}

TEST(MethodObstacle, PeopleNeedACalibrationAndColorsCanDoWithAGuess) {
  const Project project = guessed(2);
  EXPECT_EQ(obstacle(project, "people"), MethodObstacle::NoCalibration);
  EXPECT_EQ(obstacle(project, "mohedano-ms"), MethodObstacle::NoCalibration);
  EXPECT_EQ(obstacle(project, "dewpoint"), MethodObstacle::None);
  EXPECT_EQ(obstacle(project, "histogram"), MethodObstacle::None);
}

// What createNewProject() chooses for one camera is what can work with it.
TEST(MethodObstacle, OneCameraWithoutACalibrationIsForBoxesOnly) {
  const Project project = guessed(1);
  EXPECT_EQ(obstacle(project, project.method.c_str()), MethodObstacle::None);
  EXPECT_EQ(obstacle(project, "sugandi"), MethodObstacle::None);
  EXPECT_EQ(obstacle(project, "dewpoint"), MethodObstacle::NoCalibration);
  EXPECT_EQ(obstacle(project, "barrera"), MethodObstacle::NoCalibration);
}

TEST(MethodObstacle, WhatTriangulatesNeedsTwoCameras) {
  const Project project = calibrated(1);
  EXPECT_EQ(obstacle(project, "dynamics"), MethodObstacle::TooFewCameras);
  EXPECT_EQ(obstacle(project, "people"), MethodObstacle::TooFewCameras);
  EXPECT_EQ(obstacle(project, "dewpoint"), MethodObstacle::None);
}

// A project file for boxes may say nothing of its cameras; checkProject() refuses others with it.
TEST(MethodObstacle, CamerasOfUnknownSizeAreForBoxesOnly) {
  Project project = calibrated(2);
  project.cameras[1].camera.intrinsics = {};
  EXPECT_EQ(obstacle(project, "dewpoint"), MethodObstacle::NoCalibration);
  EXPECT_EQ(obstacle(project, "histogram"), MethodObstacle::None);
}

} // namespace
} // namespace dewpoint::tests
