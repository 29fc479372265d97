// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/new_project/project_devices.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

using capture::CameraDevice;
using capture::ColorAutomatic;

/// A webcam that can send 1920 x 1080 uncompressed or as JPEG, on a slow bus.
CameraDevice webcam(int number, const std::string& serial) {
  CameraDevice device;
  device.path = "/dev/video" + std::to_string(number);
  device.stablePath = "/dev/v4l/by-id/webcam-" + serial;
  device.identity = {"usb-0:" + std::to_string(number) + ":1.0", serial, "Webcam", "046d:082d"};
  device.usbLink = {1, 480.0, 480.0};
  device.formats = {{"MJPG", "Motion-JPEG", true, {{1920, 1080, {30.0, 15.0}}}},
                    {"YUYV", "YUYV 4:2:2", false, {{1920, 1080, {30.0, 5.0}}}}};
  return device;
}

Project projectWith(std::initializer_list<CameraSource> sources) {
  Project project;
  EXPECT_TRUE(addCameras(project, sources));
  return project;
}

TEST(ProjectDevices, CamerasHaveTheirDeviceByIdentityOrByPlace) {
  const std::vector<CameraDevice> present{webcam(0, "A"), webcam(2, "B"), webcam(4, "C")};
  CameraSource moved = sourceOf(present[1]);
  EXPECT_EQ(moved.location, "/dev/v4l/by-id/webcam-B");
  moved.location = "/dev/video0"; // before the restart
  const Project project = projectWith({moved,
                                       {"", SourceKind::Device, "4", {}, {}},
                                       {"", SourceKind::Device, "/dev/video0", {}, {}},
                                       {"", SourceKind::Stream, "test:ball", {}, {}},
                                       {"", SourceKind::Device, "9", {}, {}}});
  const auto matches = matchProjectDevices(project, present);
  ASSERT_EQ(matches.size(), 5U);
  EXPECT_EQ(matches[0].deviceIndex, 1U);
  EXPECT_EQ(matches[1].deviceIndex, 2U);
  EXPECT_EQ(matches[2].deviceIndex, 0U);
  EXPECT_FALSE(matches[3].deviceIndex);
  EXPECT_FALSE(matches[4].deviceIndex);
}

TEST(ProjectDevices, ShortagesNameTheCamerasOfTheProject) {
  const std::vector<CameraDevice> present{webcam(0, "A"), webcam(2, "B")};
  Project project = projectWith(
      {{"", SourceKind::Stream, "test:ball", {}, {}}, sourceOf(present[0]), sourceOf(present[1])});
  EXPECT_TRUE(projectBandwidthShortages(project, present).empty()); // JPEG fits
  for (const std::size_t k : {1U, 2U}) {
    project.cameras[k].device.format = {"YUYV", 1920, 1080, 30.0};
  }
  const auto shortages = projectBandwidthShortages(project, present);
  ASSERT_EQ(shortages.size(), 1U);
  EXPECT_EQ(shortages[0].requestIndices, (std::vector<std::size_t>{1, 2}));
  for (const auto& proposal : shortages[0].proposals) {
    EXPECT_TRUE(proposal.requestIndex == 1 || proposal.requestIndex == 2);
  }
}

/// A webcam without JPEG on a bus that can carry two of its small images, but no large ones.
CameraDevice rawWebcam(int number, const std::string& serial) {
  CameraDevice device = webcam(number, serial);
  device.formats = {{"YUYV", "YUYV 4:2:2", false, {{1920, 1080, {30.0}}, {640, 480, {30.0}}}}};
  return device;
}

TEST(ProjectDevices, ACalibratedCameraIsOpenedInTheSizeOfItsCalibration) {
  const std::vector<CameraDevice> present{rawWebcam(0, "A"), rawWebcam(2, "B")};
  Project project = projectWith({sourceOf(present[0]), sourceOf(present[1])});
  EXPECT_EQ(projectBandwidthShortages(project, present).size(), 1U); // guessed: the largest size
  for (ProjectCamera& camera : project.cameras) {
    camera.camera.intrinsics = {640, 480, 700.0, 700.0, 320.0, 240.0};
  }
  EXPECT_TRUE(projectBandwidthShortages(project, present).empty());
  for (ProjectCamera& camera : project.cameras) { // as the images are after their rotation
    camera.rotateDegrees = 90;
    camera.camera.intrinsics = {480, 640, 700.0, 700.0, 240.0, 320.0};
  }
  EXPECT_TRUE(projectBandwidthShortages(project, present).empty());
  for (ProjectCamera& camera : project.cameras) {
    camera.camera.intrinsics = {1080, 1920, 700.0, 700.0, 540.0, 960.0};
  }
  EXPECT_EQ(projectBandwidthShortages(project, present).size(), 1U);
  for (ProjectCamera& camera : project.cameras) {
    camera.camera.intrinsics = {1440, 2560, 700.0, 700.0, 720.0, 1280.0}; // cannot be opened
  }
  EXPECT_TRUE(projectBandwidthShortages(project, present).empty());
}

TEST(ProjectDevices, AutomaticsThatAreOnAreNamed) {
  capture::DeviceControl exposure;
  exposure.name = "auto_exposure";
  exposure.value = 3; // aperture priority
  capture::DeviceControl balance;
  balance.name = "white_balance_automatic";
  balance.value = 0;
  EXPECT_EQ(automaticsOn({exposure, balance}),
            std::vector<ColorAutomatic>{ColorAutomatic::Exposure});
  exposure.value = 1;
  balance.value = 1;
  EXPECT_EQ(automaticsOn({exposure, balance}),
            std::vector<ColorAutomatic>{ColorAutomatic::WhiteBalance});
  EXPECT_TRUE(automaticsOn({}).empty());
}

} // namespace
} // namespace dewpoint::tests
