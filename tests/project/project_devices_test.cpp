// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_changes.h"
#include "core/project/project_check.h"
#include "core/project/project_devices.h"
#include "core/project/project_save.h"
#include "tests/project/loaded_text.h"

#include <gtest/gtest.h>

#include <functional>

namespace dewpoint::tests {
namespace {

constexpr const char* kWithDevice = R"(format = 2
name = "live"
method = "histogram"

[[camera]]
name = "left"
device = "/dev/video0"
pixel_format = "MJPG"
size = [1280, 720]
rate = 29.97
rotate = 90
[camera.identity]
bus = "pci-0000:00:14.0-usb-0:3:1.0"
serial = "A5"
name = "HD \"Webcam\""
vendor_product = "046d:0825"
[camera.controls]
auto_exposure = 1
exposure_time_absolute = 157
tilt_absolute = -3600

[[camera]]
name = "right"
device = "1"
)";

TEST(ProjectDevices, AreReadAndSavedUnchanged) {
  const auto project = load(kWithDevice);
  ASSERT_TRUE(project) << errorSentence(project.error());
  ASSERT_EQ(project->cameras.size(), 2U);
  const DeviceSettings& left = project->cameras[0].device;
  EXPECT_EQ(left.identity,
            (DeviceIdentity{"pci-0000:00:14.0-usb-0:3:1.0", "A5", "HD \"Webcam\"", "046d:0825"}));
  EXPECT_EQ(left.format, (DeviceFormat{"MJPG", 1280, 720, 29.97}));
  EXPECT_EQ(left.controls,
            (ControlValues{
                {"auto_exposure", 1}, {"exposure_time_absolute", 157}, {"tilt_absolute", -3600}}));
  EXPECT_EQ(project->cameras[1].device, DeviceSettings{});
  const auto file = fileNamed("saved.toml");
  Project calibrated = *project; // a file has the calibration of each camera
  for (ProjectCamera& camera : calibrated.cameras) {
    camera.camera.intrinsics = {640, 480, 500.0, 500.0, 319.5, 239.5};
  }
  ASSERT_TRUE(saveProject(calibrated, file));
  const auto again = loadProject(file);
  ASSERT_TRUE(again) << errorSentence(again.error());
  EXPECT_EQ(again->cameras[0].device, left);
  EXPECT_EQ(again->cameras[1].device, DeviceSettings{});
}

TEST(ProjectDevices, AreNotWrittenUnlessGiven) {
  EXPECT_EQ(deviceFormatText({}), "");
  EXPECT_EQ(deviceTablesText({}), "");
  const auto project = load(kWithDevice);
  ASSERT_TRUE(project) << errorSentence(project.error());
  Project other = *project;
  other.cameras[0].source = SourceKind::Stream; // it has no device any more
  other.cameras[0].location = "test:ball";
  const std::string text = projectText(other, "/");
  for (const char* key : {"pixel_format", "[camera.identity]", "[camera.controls]", "rate ="}) {
    EXPECT_EQ(text.find(key), std::string::npos) << key;
  }
}

std::string deviceFieldOf(const std::string& from, const std::string& to) {
  const auto project = load(kWithDevice, from, to);
  EXPECT_FALSE(project) << from << " -> " << to;
  if (project) {
    return {};
  }
  EXPECT_NE(project.error().file, "");
  return project.error().field;
}

TEST(ProjectDevices, WrongValuesAreNamed) {
  EXPECT_EQ(deviceFieldOf("\"MJPG\"", "\"MJPEG\""), "camera 1.pixel_format");
  EXPECT_EQ(deviceFieldOf("\"MJPG\"", "7"), "camera 1.pixel_format");
  EXPECT_EQ(deviceFieldOf("[1280, 720]", "[1280]"), "camera 1.size");
  EXPECT_EQ(deviceFieldOf("[1280, 720]", "[1280, 0]"), "camera 1.size");
  EXPECT_EQ(deviceFieldOf("[1280, 720]", "[1280, 720.5]"), "camera 1.size");
  EXPECT_EQ(deviceFieldOf("= 29.97", "= 0"), "camera 1.rate");
  EXPECT_EQ(deviceFieldOf("= 29.97", "= \"fast\""), "camera 1.rate");
  EXPECT_EQ(deviceFieldOf("046d:0825", "046d"), "camera 1.identity.vendor_product");
  EXPECT_EQ(deviceFieldOf("\"A5\"", "5"), "camera 1.identity.serial");
  EXPECT_EQ(deviceFieldOf("serial", "number"), "camera 1.identity.number");
  EXPECT_EQ(deviceFieldOf("\"A5\"", "\"" + std::string(501, 'x') + "\""),
            "camera 1.identity.serial");
  EXPECT_EQ(deviceFieldOf("= 157", "= 157.5"), "camera 1.controls.exposure_time_absolute");
  EXPECT_EQ(deviceFieldOf("auto_exposure", "\"Auto Exposure\""), "camera 1.controls.Auto Exposure");
}

TEST(ProjectDevices, OnlyDevicesHaveThem) {
  EXPECT_EQ(deviceFieldOf("device = \"/dev/video0\"", "stream = \"test:ball\""),
            "camera 1.pixel_format");
}

TEST(ProjectDevices, AreChecked) {
  const auto project = load(kWithDevice);
  ASSERT_TRUE(project) << errorSentence(project.error());
  const auto fieldAfter = [&](const std::function<void(DeviceSettings&)>& change) {
    Project changed = *project;
    change(changed.cameras[1].device);
    const auto good = checkProject(changed);
    return good ? std::string() : good.error().field;
  };
  EXPECT_EQ(fieldAfter([](DeviceSettings&) {}), "");
  EXPECT_EQ(fieldAfter([](DeviceSettings& one) { one.format.width = 640; }), "camera 2.size");
  EXPECT_EQ(fieldAfter([](DeviceSettings& one) { one.format.frameRate = -1.0; }), "camera 2.rate");
  EXPECT_EQ(fieldAfter([](DeviceSettings& one) { one.controls["a b"] = 1; }),
            "camera 2.controls.a b");
}

TEST(ProjectDevices, ChangesOfControlsDoNotOpenTheDeviceAgain) {
  const auto before = load(kWithDevice);
  ASSERT_TRUE(before) << errorSentence(before.error());
  Project after = *before;
  after.cameras[0].device.controls["gain"] = 3;
  const ProjectChanges controls = changesBetween(*before, after);
  EXPECT_TRUE(controls.controlsChanged);
  EXPECT_TRUE(controls.hasAny());
  EXPECT_FALSE(controls.sourcesChanged);
  EXPECT_FALSE(controls.calibrationChanged);
  after.cameras[0].device.format.frameRate = 15.0;
  const ProjectChanges format = changesBetween(*before, after);
  EXPECT_TRUE(format.sourcesChanged);
  EXPECT_FALSE(format.controlsChanged);
}

} // namespace
} // namespace dewpoint::tests
