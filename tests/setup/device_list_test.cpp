// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/device_list.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace dewpoint::tests {
namespace {

ListedDevice listedWebcam() {
  ListedDevice listed;
  CameraDevice& device = listed.device;
  device.path = "/dev/video0";
  device.stablePath = "/dev/v4l/by-id/usb-A5-video-index0";
  device.identity = {"pci-0:3:1.0", "A5", "HD Webcam", "046d:0825"};
  device.driver = "uvcvideo";
  device.usbLink = {1, 480.0, 480.0};
  device.formats = {{"MJPG", "Motion-JPEG", true, {{1280, 720, {30.0, 7.5}}}, false},
                    {"YUYV", "YUYV 4:2:2", false, {{640, 480, {}}}, true}};
  return listed;
}

std::vector<DeviceControl> listedControls() {
  DeviceControl exposure;
  exposure.name = "exposure_time_absolute";
  exposure.minimum = 3;
  exposure.maximum = 2047;
  exposure.defaultValue = 250;
  exposure.value = 157;
  exposure.isInactive = true;
  DeviceControl automatic;
  automatic.name = "auto_exposure";
  automatic.kind = ControlKind::Menu;
  automatic.maximum = 3;
  automatic.defaultValue = automatic.value = 3;
  automatic.menuItems = {{1, "Manual Mode"}, {3, "Aperture Priority Mode"}};
  return {exposure, automatic};
}

TEST(DeviceList, IsTextForPeople) {
  ListedDevice first = listedWebcam();
  first.controls = listedControls();
  ListedDevice second;
  second.device.path = second.device.stablePath = "/dev/video2";
  second.device.identity = {"usb-2", "", "Other", ""};
  second.device.problem = "it cannot be opened: another program uses it";
  EXPECT_EQ(deviceListText(std::vector{first, second}),
            "HD Webcam\n"
            "  address    /dev/v4l/by-id/usb-A5-video-index0\n"
            "  node       /dev/video0\n"
            "  connector  pci-0:3:1.0 (USB bus 1, 480 Mbit/s)\n"
            "  serial     A5\n"
            "  format     MJPG: 1280x720 at 30, 7.5\n"
            "  format     YUYV: 640x480; and other sizes\n"
            "  control    exposure_time_absolute = 157 (3 to 2047, default 250, set by an "
            "automatic now)\n"
            "  control    auto_exposure = 3 (1 = Manual Mode, 3 = Aperture Priority Mode, default "
            "3)\n"
            "\n"
            "Other\n"
            "  address    /dev/video2\n"
            "  connector  usb-2\n"
            "  serial     none\n"
            "  problem    it cannot be opened: another program uses it\n");
  EXPECT_EQ(deviceListText({}), "");
}

TEST(DeviceList, IsJsonForPrograms) {
  ListedDevice device = listedWebcam();
  device.device.identity.name = "HD \xff Webcam"; // no UTF-8
  const auto plain = nlohmann::json::parse(deviceListJson(std::vector{device}));
  ASSERT_EQ(plain.size(), 1U);
  EXPECT_FALSE(plain[0].contains("controls"));
  EXPECT_EQ(plain[0]["address"], "/dev/v4l/by-id/usb-A5-video-index0");
  EXPECT_EQ(plain[0]["serial"], "A5");
  EXPECT_EQ(plain[0]["formats"][0]["sizes"][0]["rates"], (std::vector<double>{30.0, 7.5}));
  device.controls = listedControls();
  const auto full = nlohmann::json::parse(deviceListJson(std::vector{device}));
  EXPECT_EQ(full[0]["controls"][0]["maximum"], 2047);
  EXPECT_EQ(full[0]["controls"][1]["menu"][1]["value"], 3);
  EXPECT_EQ(deviceListJson({}), "[]");
}

TEST(IdentifyDevices, OnlyThoseThatHaveNoIdentity) {
  const std::vector<CameraDevice> devices{listedWebcam().device};
  Project project;
  project.cameras.resize(4);
  project.cameras[0].source = SourceKind::Device;
  project.cameras[0].location = "0";
  project.cameras[1].source = SourceKind::Device;
  project.cameras[1].location = "/dev/video7"; // not connected
  project.cameras[2].source = SourceKind::Stream;
  project.cameras[2].location = "/dev/video0";
  project.cameras[3].source = SourceKind::Device;
  project.cameras[3].location = "/dev/video3";
  project.cameras[3].device.identity.serial = "other";
  EXPECT_EQ(identifyDevices(project, devices), 1U);
  EXPECT_EQ(project.cameras[0].device.identity, devices[0].identity);
  EXPECT_EQ(project.cameras[0].location, devices[0].stablePath);
  EXPECT_TRUE(project.cameras[1].device.identity.isEmpty());
  EXPECT_TRUE(project.cameras[2].device.identity.isEmpty());
  EXPECT_EQ(project.cameras[3].device.identity.serial, "other");
  EXPECT_EQ(identifyDevices(project, devices), 0U);
}

} // namespace
} // namespace dewpoint::tests
