// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/capture/devices/fake_machine.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

/// A webcam with a node for images and one for metadata, as UVC cameras have them.
void plugWebcam(FakeMachine& machine, int number, const std::string& port,
                const std::string& serial = "") {
  FakeNode images;
  images.name = "video" + std::to_string(number);
  images.port = port;
  images.serial = serial;
  images.formats = {fakeMjpg(), fakeYuyv()};
  images.controls = fakeControls();
  machine.plug(images);
  FakeNode metadata;
  metadata.name = "video" + std::to_string(number + 1);
  metadata.port = ""; // the same device as the first: its links are there already
  metadata.index = 1;
  metadata.abilities = V4L2_CAP_META_CAPTURE | V4L2_CAP_STREAMING;
  machine.plug(metadata);
}

TEST(LinuxDevices, ListsCamerasWithTheirFormats) {
  const auto machine = std::make_shared<FakeMachine>();
  plugWebcam(*machine, 10, "4", "B7");
  plugWebcam(*machine, 2, "3", "A5");
  const auto devices = accessTo(machine)->listDevices();
  ASSERT_EQ(devices.size(), 2U); // without the nodes for metadata
  const CameraDevice& first = devices[0];
  EXPECT_EQ(first.path, "/dev/video2"); // by number, not by text
  EXPECT_EQ(first.stablePath, "/dev/v4l/by-id/usb-046d_Webcam_A5-video-index0");
  EXPECT_EQ(first.identity,
            (DeviceIdentity{"pci-0000:00:14.0-usb-0:3:1.0", "A5", "HD Webcam", "046d:0825"}));
  EXPECT_EQ(first.driver, "uvcvideo");
  EXPECT_EQ(first.usbLink, (UsbLink{1, 480.0, 480.0}));
  EXPECT_EQ(first.problem, "");
  ASSERT_EQ(first.formats.size(), 2U);
  const OfferedFormat& mjpg = first.formats[0];
  EXPECT_EQ(mjpg.pixelFormat, "MJPG");
  EXPECT_EQ(mjpg.description, "Motion-JPEG");
  EXPECT_TRUE(mjpg.isCompressed);
  EXPECT_FALSE(mjpg.hasOtherSizes);
  EXPECT_EQ(mjpg.sizes, (std::vector<OfferedSize>{{1280, 720, {30.0}}, {640, 480, {30.0, 15.0}}}));
  EXPECT_FALSE(first.formats[1].isCompressed);
  EXPECT_EQ(devices[1].path, "/dev/video10");
  EXPECT_EQ(machine->openCount(), 0); // all are closed again
}

TEST(LinuxDevices, LeavesOutWhatIsNoCamera) {
  const auto machine = std::make_shared<FakeMachine>();
  FakeNode node;
  node.port = "";
  node.formats = {fakeYuyv()};
  const std::vector<std::uint32_t> abilities{
      V4L2_CAP_VIDEO_OUTPUT, V4L2_CAP_VIDEO_M2M, V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_VIDEO_M2M,
      V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_IO_MC, V4L2_CAP_META_CAPTURE};
  for (std::size_t k = 0; k < abilities.size(); ++k) {
    node.name = "video" + std::to_string(k);
    node.abilities = abilities[k];
    machine->plug(node);
  }
  node.name = "video20"; // of a camera, but without a format
  node.abilities = V4L2_CAP_VIDEO_CAPTURE;
  node.formats.clear();
  machine->plug(node);
  EXPECT_TRUE(accessTo(machine)->listDevices().empty());
}

TEST(LinuxDevices, IsEmptyWithoutVideoDevices) {
  const test::TemporaryFolder nothing;
  LinuxDevices devices(nothing / "nowhere", std::make_shared<FakeMachine>());
  EXPECT_TRUE(devices.listDevices().empty());
  EXPECT_EQ(devices.deviceListSignature(), "");
  EXPECT_EQ(devices.readControls("/dev/video0").error().code, ErrorCode::DeviceUnavailable);
}

TEST(LinuxDevices, SaysWhyADeviceCannotBeUsed) {
  const auto machine = std::make_shared<FakeMachine>();
  FakeNode node;
  node.openError = EACCES;
  machine->plug(node);
  node.name = "video1"; // its metadata, most likely
  node.index = 1;
  machine->plug(node);
  const auto devices = accessTo(machine)->listDevices();
  ASSERT_EQ(devices.size(), 1U);
  EXPECT_NE(devices[0].problem.find("group 'video'"), std::string::npos) << devices[0].problem;
  EXPECT_EQ(devices[0].identity.name, "HD Webcam");
  EXPECT_TRUE(devices[0].formats.empty());
}

TEST(LinuxDevices, GivesEqualSerialNumbersTheirConnectors) {
  const auto machine = std::make_shared<FakeMachine>();
  plugWebcam(*machine, 0, "3", "SN0001");
  plugWebcam(*machine, 2, "4", "SN0001");
  const auto devices = accessTo(machine)->listDevices();
  ASSERT_EQ(devices.size(), 2U);
  EXPECT_EQ(devices[0].stablePath, "/dev/v4l/by-path/pci-0000:00:14.0-usb-0:3:1.0-video-index0");
  EXPECT_EQ(devices[1].stablePath, "/dev/v4l/by-path/pci-0000:00:14.0-usb-0:4:1.0-video-index0");
}

TEST(LinuxDevices, TakesTheUsualSizesOfARange) {
  const auto machine = std::make_shared<FakeMachine>();
  FakeNode node;
  node.port = "";
  node.formats = {fakeYuyv()};
  machine->plug(node);
  // Answers with a range, as loopback devices do.
  class RangedCalls final : public LinuxCalls {
  public:
    explicit RangedCalls(std::shared_ptr<FakeMachine> machine) : machine_(std::move(machine)) {}
    int open(const std::string& path) override { return machine_->open(path); }
    void close(int descriptor) override { machine_->close(descriptor); }
    int callIoctl(int descriptor, unsigned long request, void* argument) override {
      if (request == VIDIOC_ENUM_FRAMESIZES) {
        auto& entry = *static_cast<v4l2_frmsizeenum*>(argument);
        entry.type = V4L2_FRMSIZE_TYPE_CONTINUOUS;
        entry.stepwise = {48, 1500, 1, 32, 1000, 1};
        return entry.index == 0 ? 0 : -EINVAL;
      }
      if (request == VIDIOC_ENUM_FRAMEINTERVALS) {
        auto& entry = *static_cast<v4l2_frmivalenum*>(argument);
        entry.type = V4L2_FRMIVAL_TYPE_CONTINUOUS;
        entry.stepwise.min = {1, 40};
        entry.stepwise.max = {1, 1};
        return entry.index == 0 ? 0 : -EINVAL;
      }
      return machine_->callIoctl(descriptor, request, argument);
    }

  private:
    std::shared_ptr<FakeMachine> machine_;
  };
  LinuxDevices devices(machine->root(), std::make_shared<RangedCalls>(machine));
  const auto list = devices.listDevices();
  ASSERT_EQ(list.size(), 1U);
  const OfferedFormat& format = list[0].formats.at(0);
  EXPECT_TRUE(format.hasOtherSizes);
  EXPECT_EQ(format.sizes.front().width, 1500);
  EXPECT_EQ(format.sizes.back().width, 48);
  const std::vector<double> rates{40.0, 30.0, 25.0, 20.0, 15.0, 10.0, 1.0};
  EXPECT_EQ(format.sizes.front().frameRates, rates);
  EXPECT_EQ(std::ranges::count(format.sizes, 1280, &OfferedSize::width), 2); // 720 and 960 rows
  EXPECT_TRUE(isOffered({"YUYV", 1000, 700, 0.0}, list[0].formats));
}

TEST(LinuxDevices, SignatureChangesWithThePlug) {
  const auto machine = std::make_shared<FakeMachine>();
  const auto access = accessTo(machine);
  plugWebcam(*machine, 0, "3");
  const std::string before = access->deviceListSignature();
  EXPECT_EQ(access->deviceListSignature(), before);
  EXPECT_EQ(machine->openCount(), 0);
  machine->unplug("video0");
  const std::string without = access->deviceListSignature();
  EXPECT_NE(without, before);
  plugWebcam(*machine, 0, "4");
  EXPECT_NE(access->deviceListSignature(), without);
  EXPECT_NE(access->deviceListSignature(), before);
}

TEST(LinuxDevices, ListsControlsUnderTheirNames) {
  const auto machine = std::make_shared<FakeMachine>();
  plugWebcam(*machine, 0, "3");
  const auto controls = accessTo(machine)->readControls("/dev/video0");
  ASSERT_TRUE(controls) << errorSentence(controls.error());
  std::vector<std::string> names;
  for (const DeviceControl& control : *controls) {
    names.push_back(control.name);
  }
  // Labels of an old kernel; names of a new one.
  EXPECT_EQ(names, (std::vector<std::string>{"brightness", "white_balance_automatic", "gain",
                                             "white_balance_temperature", "auto_exposure",
                                             "exposure_time_absolute"}));
  const DeviceControl& exposure = controls->at(5);
  EXPECT_EQ(exposure.label, "Exposure (Absolute)");
  EXPECT_EQ(exposure.minimum, 3);
  EXPECT_EQ(exposure.maximum, 2047);
  EXPECT_EQ(exposure.value, 250);
  EXPECT_TRUE(exposure.isInactive); // the automatic is on
  EXPECT_EQ(controls->at(1).kind, ControlKind::Boolean);
  const std::vector<ControlMenuItem> menu{{1, "Manual Mode"}, {3, "Aperture Priority Mode"}};
  EXPECT_EQ(controls->at(4).menuItems, menu); // only what the device has
}

TEST(LinuxDevices, SetsControls) {
  const auto machine = std::make_shared<FakeMachine>();
  plugWebcam(*machine, 0, "3");
  const auto access = accessTo(machine);
  const std::string byPath = "/dev/v4l/by-path/pci-0000:00:14.0-usb-0:3:1.0-video-index0";
  ASSERT_TRUE(access->setControl(byPath, "gain", 99));
  EXPECT_EQ(machine->valueOf("video0", V4L2_CID_GAIN), 99);
  const auto codeOf = [&](const std::string& path, const char* name, std::int64_t value) {
    const auto set = access->setControl(path, name, value);
    EXPECT_FALSE(set) << name;
    EXPECT_EQ(set.error().field, name);
    return set.error().code;
  };
  EXPECT_EQ(codeOf(byPath, "gain", 256), ErrorCode::BadValue);
  EXPECT_EQ(codeOf(byPath, "zoom_absolute", 1), ErrorCode::NotFound);
  EXPECT_EQ(codeOf(byPath, "exposure_time_absolute", 100), ErrorCode::BadValue); // automatic is on
  EXPECT_EQ(codeOf(byPath, "auto_exposure", 2), ErrorCode::BadValue);            // not in its menu
  EXPECT_EQ(codeOf("/dev/video7", "gain", 1), ErrorCode::DeviceUnavailable);
}

} // namespace
} // namespace dewpoint::tests
