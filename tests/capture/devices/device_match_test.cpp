// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/devices/device_match.h"

#include <gtest/gtest.h>

#include <array>

namespace dewpoint::tests {
namespace {

CameraDevice deviceOf(const std::string& path, const DeviceIdentity& identity) {
  CameraDevice device;
  device.path = path;
  device.identity = identity;
  return device;
}

/// Two equal webcams without serial number.
const DeviceIdentity kLeftTwin{"usb-0:1:1.0", "", "Webcam", "046d:0825"};
const DeviceIdentity kRightTwin{"usb-0:2:1.0", "", "Webcam", "046d:0825"};

DeviceIdentity pluggedAt(DeviceIdentity identity, const std::string& bus) {
  identity.bus = bus;
  return identity;
}

TEST(DeviceMatch, NumbersMayChange) {
  // After a restart, the order is the other one.
  const std::vector<CameraDevice> devices{deviceOf("/dev/video0", kRightTwin),
                                          deviceOf("/dev/video2", kLeftTwin)};
  const std::array<DeviceIdentity, 2> cameras{kLeftTwin, kRightTwin};
  const auto matches = matchDevices(cameras, devices);
  EXPECT_EQ(matches[0].deviceIndex, 1U);
  EXPECT_EQ(matches[1].deviceIndex, 0U);
  EXPECT_EQ(matches[0].basis, MatchBasis::Bus);
  EXPECT_EQ(mismatchReason(matches[0], kLeftTwin, devices), "");
}

TEST(DeviceMatch, TheSerialNumberBeatsTheConnector) {
  const DeviceIdentity a{"usb-0:1:1.0", "A", "Webcam", "046d:0825"};
  const DeviceIdentity b{"usb-0:2:1.0", "B", "Webcam", "046d:0825"};
  const std::vector<CameraDevice> exchanged{deviceOf("/dev/video0", pluggedAt(b, a.bus)),
                                            deviceOf("/dev/video2", pluggedAt(a, b.bus))};
  const std::array<DeviceIdentity, 2> cameras{a, b};
  const auto matches = matchDevices(cameras, exchanged);
  EXPECT_EQ(matches[0].deviceIndex, 1U);
  EXPECT_EQ(matches[1].deviceIndex, 0U);
  EXPECT_EQ(matches[0].basis, MatchBasis::Serial);
}

TEST(DeviceMatch, EqualSerialNumbersProveNothing) {
  const DeviceIdentity a{"usb-0:1:1.0", "SN0001", "Webcam", "046d:0825"};
  const DeviceIdentity b = pluggedAt(a, "usb-0:2:1.0");
  const std::vector<CameraDevice> devices{deviceOf("/dev/video0", b), deviceOf("/dev/video2", a)};
  const std::array<DeviceIdentity, 2> cameras{a, b};
  const auto matches = matchDevices(cameras, devices);
  EXPECT_EQ(matches[0].deviceIndex, 1U);
  EXPECT_EQ(matches[1].deviceIndex, 0U);
  EXPECT_EQ(matches[0].basis, MatchBasis::Bus);
}

TEST(DeviceMatch, TheOnlyOneLeftWasMoved) {
  const std::vector<CameraDevice> devices{
      deviceOf("/dev/video0", pluggedAt(kLeftTwin, "usb-0:7:1.0")),
      deviceOf("/dev/video2", kRightTwin)};
  const std::array<DeviceIdentity, 2> cameras{kLeftTwin, kRightTwin};
  const auto matches = matchDevices(cameras, devices);
  EXPECT_EQ(matches[0].deviceIndex, 0U);
  EXPECT_EQ(matches[0].basis, MatchBasis::Name);
  EXPECT_EQ(matches[1].deviceIndex, 1U);
}

TEST(DeviceMatch, MovedTwinsAreAmbiguous) {
  const std::vector<CameraDevice> devices{
      deviceOf("/dev/video0", pluggedAt(kLeftTwin, "usb-0:7:1.0")),
      deviceOf("/dev/video2", pluggedAt(kLeftTwin, "usb-0:8:1.0"))};
  const std::array<DeviceIdentity, 2> cameras{kLeftTwin, kRightTwin};
  const auto matches = matchDevices(cameras, devices);
  for (const DeviceMatch& match : matches) {
    EXPECT_FALSE(match.deviceIndex);
    EXPECT_TRUE(match.isAmbiguous());
    EXPECT_EQ(match.candidateIndices, (std::vector<std::size_t>{0, 1}));
  }
  const std::string reason = mismatchReason(matches[0], kLeftTwin, devices);
  EXPECT_NE(reason.find("'Webcam' at /dev/video0, 'Webcam' at /dev/video2"), std::string::npos)
      << reason;
}

TEST(DeviceMatch, TwoCamerasDoNotShareADevice) {
  const std::vector<CameraDevice> devices{
      deviceOf("/dev/video0", pluggedAt(kLeftTwin, "usb-0:7:1.0"))};
  const std::array<DeviceIdentity, 2> cameras{kLeftTwin, kRightTwin};
  for (const DeviceMatch& match : matchDevices(cameras, devices)) {
    EXPECT_FALSE(match.deviceIndex);
    EXPECT_EQ(match.candidateIndices, std::vector<std::size_t>{0});
  }
  const std::vector<CameraDevice> right{deviceOf("/dev/video0", kRightTwin)};
  const auto matches = matchDevices(cameras, right);
  EXPECT_TRUE(matches[0].isMissing());
  EXPECT_EQ(matches[1].deviceIndex, 0U);
}

TEST(DeviceMatch, AnotherUnitOrModelIsNotTaken) {
  const DeviceIdentity wanted{"usb-0:1:1.0", "A", "Webcam", "046d:0825"};
  DeviceIdentity otherUnit = wanted;
  otherUnit.serial = "B";
  const DeviceMatch unit = matchDevice(wanted, std::vector{deviceOf("/dev/video0", otherUnit)});
  EXPECT_FALSE(unit.deviceIndex);
  EXPECT_EQ(unit.candidateIndices, std::vector<std::size_t>{0}); // the user may have replaced it
  DeviceIdentity otherModel = wanted;
  otherModel.vendorAndProductId = "1234:0001";
  const std::vector<CameraDevice> devices{deviceOf("/dev/video0", otherModel)};
  const DeviceMatch model = matchDevice(wanted, devices);
  EXPECT_TRUE(model.isMissing());
  EXPECT_EQ(mismatchReason(model, wanted, devices), "'Webcam' (serial number A) is not connected");
}

TEST(DeviceMatch, TakesWhatIsKnown) {
  const std::vector<CameraDevice> devices{deviceOf("/dev/video0", kLeftTwin)};
  EXPECT_EQ(matchDevice({kLeftTwin.bus, "", "", ""}, devices).basis, MatchBasis::Bus);
  EXPECT_EQ(matchDevice({"", "", "Webcam", ""}, devices).basis, MatchBasis::Name);
  EXPECT_TRUE(matchDevice({}, devices).isMissing());
  EXPECT_TRUE(matchDevice(kLeftTwin, {}).isMissing());
}

} // namespace
} // namespace dewpoint::tests
