// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/manual/moved_camera_pose.h"
#include "core/session/watch/camera_repair.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

Project twoVideos() {
  Project project;
  project.cameras.resize(2);
  for (int k = 0; k < 2; ++k) {
    ProjectCamera& camera = project.cameras[static_cast<std::size_t>(k)];
    camera.camera.name = k == 0 ? "left" : "right";
    camera.camera.intrinsics = {320, 240, 300.0 + k, 300.0, 159.5, 119.5};
    camera.camera.cameraFromWorld = lookAt({1.0 - 2.0 * k, 0.1, 0.5}, {0.0, 0.0, 0.0});
    camera.source = SourceKind::Video;
    camera.location = k == 0 ? "/a.mkv" : "/b.mkv";
    camera.delay = 0.1 * k;
  }
  return project;
}

TEST(CameraMending, SwappedCamerasGetEachOthersImagesWithTheClicksInThem) {
  Project project = twoVideos();
  project.measuredPoints.push_back({"corner", Eigen::Vector3d::Zero(), {{0, {10.0, 20.0}}}});
  const Project before = project;
  repairCameras(project, {.fault = CameraFault::Swapped, .cameras = {0, 1}}, 0);
  EXPECT_EQ(project.cameras[0].camera, before.cameras[0].camera);
  EXPECT_EQ(project.cameras[0].location, "/b.mkv");
  EXPECT_EQ(project.cameras[1].location, "/a.mkv");
  EXPECT_DOUBLE_EQ(project.cameras[0].delay, 0.1);
  EXPECT_EQ(project.measuredPoints[0].clicks[0].camera, 1);
  repairCameras(project, {.fault = CameraFault::Swapped, .cameras = {0, 1}}, 0);
  EXPECT_EQ(project, before);
}

TEST(CameraMending, TheSecondOfTwoWaysExchangesTheSecondPair) {
  Project project = twoVideos();
  const CameraDisagreement found{.fault = CameraFault::Swapped, .cameras = {5, 6, 0, 1}};
  ASSERT_EQ(repairChoiceCount(found), 2U);
  repairCameras(project, found, 1);
  EXPECT_EQ(project.cameras[0].location, "/b.mkv");
}

TEST(CameraMending, SimulatedCamerasAreCalibratedForEachOthersImages) {
  Project project = twoVideos();
  for (ProjectCamera& camera : project.cameras) {
    camera.source = SourceKind::Simulation;
  }
  const Project before = project;
  repairCameras(project, {.fault = CameraFault::Swapped, .cameras = {0, 1}}, 0);
  EXPECT_EQ(project.cameras[0].camera.name, "left");
  EXPECT_TRUE(
      project.cameras[0].camera.cameraFromWorld.isApprox(before.cameras[1].camera.cameraFromWorld));
  EXPECT_TRUE(project.cameras[0].hasOwnCalibration);
}

TEST(CameraMending, ADelayIsAddedToTheOneThatIsKnown) {
  Project project = twoVideos();
  repairCameras(project, {.fault = CameraFault::Late, .cameras = {1}, .delay = 0.2}, 0);
  EXPECT_DOUBLE_EQ(project.cameras[1].delay, 0.3);
}

TEST(CameraMending, ARotatedCameraIsRotatedAboutItsCenter) {
  Project project = twoVideos();
  const Camera before = project.cameras[1].camera;
  CameraDisagreement found{.fault = CameraFault::Rotated, .cameras = {0, 1}};
  found.rotationCorrections = {Eigen::Vector3d::Zero(), Eigen::Vector3d(0.0, 0.05, 0.0)};
  repairCameras(project, found, 1);
  EXPECT_EQ(project.cameras[1].camera, rotatedCamera(before, found.rotationCorrections[1]));
  EXPECT_TRUE(project.cameras[1].camera.center().isApprox(before.center(), 1e-12));
}

TEST(CameraMending, MillimetersBecomeMeters) {
  Project project = twoVideos();
  const Project before = project;
  for (ProjectCamera& camera : project.cameras) {
    camera.camera.cameraFromWorld.translation() *= 1000.0;
  }
  repairCameras(project, {.fault = CameraFault::Unit, .metersPerUnit = 0.001}, 0);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_TRUE(project.cameras[k].camera.center().isApprox(before.cameras[k].camera.center()));
  }
}

TEST(CameraMending, ACommonPoseNeedsACalibration) {
  EXPECT_EQ(repairChoiceCount({.fault = CameraFault::SamePose, .cameras = {0, 1}}), 0U);
  EXPECT_EQ(repairChoiceCount({.fault = CameraFault::Unknown, .cameras = {0}}), 0U);
}

} // namespace
} // namespace dewpoint::tests
