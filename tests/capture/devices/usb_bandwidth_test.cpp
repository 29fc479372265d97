// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/devices/usb_bandwidth.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

constexpr double kUsb2Bits = 480e6 * 0.8;

CameraDevice webcamAt(int bus, double mbit = 480.0) {
  CameraDevice device;
  device.usbLink = {bus, mbit, mbit};
  device.formats = {{"MJPG", "", true, {{1920, 1080, {30.0}}, {1280, 720, {30.0}}}, false},
                    {"YUYV",
                     "",
                     false,
                     {{1920, 1080, {5.0}}, {1280, 720, {30.0, 10.0}}, {640, 480, {30.0}}},
                     false}};
  return device;
}

CameraDevice rawAt(int bus) {
  CameraDevice device = webcamAt(bus);
  device.formats.erase(device.formats.begin());
  return device;
}

const DeviceFormat kRaw720{"YUYV", 1280, 720, 30.0};

TEST(UsbBandwidth, CountsBits) {
  EXPECT_DOUBLE_EQ(bitsPerSecond({"YUYV", 640, 480, 30.0}), 640.0 * 480 * 16 * 30);
  EXPECT_DOUBLE_EQ(bitsPerSecond({"GREY", 640, 480, 60.0}), 640.0 * 480 * 8 * 60);
  EXPECT_DOUBLE_EQ(bitsPerSecond({"YUYV", 640, 480, 0.0}), 640.0 * 480 * 16 * 30); // usual rate
  EXPECT_EQ(bitsPerSecond({"YUYV", 0, 0, 30.0}), 0.0);
  const double jpeg = bitsPerSecond({"MJPG", 1280, 720, 30.0});
  EXPECT_GT(jpeg, 0.0);
  EXPECT_LT(jpeg, bitsPerSecond(kRaw720) / 4.0);
}

TEST(UsbBandwidth, OneRawCameraFitsWhereTwoDoNot) {
  const DeviceFormat vga{"YUYV", 640, 480, 30.0}; // 147 Mbit/s
  std::vector<BandwidthRequest> requests(2, {webcamAt(1), vga});
  EXPECT_TRUE(findBandwidthShortages(requests).empty());
  requests.push_back(requests.front());
  const auto shortages = findBandwidthShortages(requests);
  ASSERT_EQ(shortages.size(), 1U);
  EXPECT_EQ(shortages[0].busNumber, 1);
  EXPECT_EQ(shortages[0].requestIndices, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_DOUBLE_EQ(shortages[0].neededBitsPerSecond, 3.0 * bitsPerSecond(vga));
  EXPECT_DOUBLE_EQ(shortages[0].availableBitsPerSecond, kUsb2Bits);
}

TEST(UsbBandwidth, ProposesCompressionAtTheSameSize) {
  const auto shortages =
      findBandwidthShortages(std::vector<BandwidthRequest>{{webcamAt(1), kRaw720}});
  ASSERT_EQ(shortages.size(), 1U); // 442 Mbit/s
  ASSERT_EQ(shortages[0].proposals.size(), 1U);
  EXPECT_EQ(shortages[0].proposals[0].requestIndex, 0U);
  EXPECT_EQ(shortages[0].proposals[0].format, (DeviceFormat{"MJPG", 1280, 720, 30.0}));
}

TEST(UsbBandwidth, ProposesALowerRateOrSizeWithoutCompression) {
  const auto one = findBandwidthShortages(std::vector<BandwidthRequest>{{rawAt(1), kRaw720}});
  ASSERT_EQ(one.size(), 1U);
  ASSERT_EQ(one[0].proposals.size(), 1U);
  EXPECT_EQ(one[0].proposals[0].format, (DeviceFormat{"YUYV", 1280, 720, 10.0}));
  // Together with others that need 147 Mbit/s each, one of them has to become lighter.
  const std::vector<BandwidthRequest> four(4, {rawAt(1), {"YUYV", 1280, 720, 10.0}});
  const auto shortages = findBandwidthShortages(four);
  ASSERT_EQ(shortages.size(), 1U);             // 4 x 147 Mbit/s
  EXPECT_TRUE(shortages[0].proposals.empty()); // nothing smaller is offered at 10 images/s or less
}

TEST(UsbBandwidth, ProposalsFit) {
  std::vector<BandwidthRequest> requests(4, {webcamAt(1), kRaw720});
  const auto shortages = findBandwidthShortages(requests);
  ASSERT_EQ(shortages.size(), 1U);
  ASSERT_FALSE(shortages[0].proposals.empty());
  for (const BandwidthProposal& proposal : shortages[0].proposals) {
    requests[proposal.requestIndex].format = proposal.format;
  }
  EXPECT_TRUE(findBandwidthShortages(requests).empty());
}

TEST(UsbBandwidth, EachBusCountsForItself) {
  EXPECT_TRUE(
      findBandwidthShortages(std::vector<BandwidthRequest>{{webcamAt(1), {"YUYV", 640, 480, 30.0}},
                                                           {webcamAt(1), {"YUYV", 640, 480, 30.0}},
                                                           {webcamAt(2), {"YUYV", 640, 480, 30.0}},
                                                           {webcamAt(2), {"YUYV", 640, 480, 30.0}}})
          .empty());
  // USB 3 carries nine of them.
  EXPECT_TRUE(
      findBandwidthShortages(std::vector<BandwidthRequest>(9, {webcamAt(2, 5000.0), kRaw720}))
          .empty());
  EXPECT_EQ(
      findBandwidthShortages(std::vector<BandwidthRequest>(10, {webcamAt(2, 5000.0), kRaw720}))
          .size(),
      1U);
  // Built in, not USB.
  EXPECT_TRUE(
      findBandwidthShortages(std::vector<BandwidthRequest>(3, {webcamAt(0), kRaw720})).empty());
}

TEST(UsbBandwidth, ADevicesOwnConnectionMayBeTheSlowest) {
  CameraDevice slow = rawAt(1);
  slow.usbLink.deviceMbitPerSecond = 12.0; // USB 1
  const auto shortages =
      findBandwidthShortages(std::vector<BandwidthRequest>{{slow, {"YUYV", 640, 480, 30.0}}});
  ASSERT_EQ(shortages.size(), 1U);
  EXPECT_TRUE(shortages[0].proposals.empty());
}

TEST(CameraFormats, WhatIsLeftOpenIsWhatOpens) {
  const CameraDevice device = webcamAt(1);
  EXPECT_EQ(completedFormat({}, device.formats), (DeviceFormat{"MJPG", 1920, 1080, 30.0}));
  EXPECT_EQ(completedFormat({"YUYV", 1280, 720, 0.0}, device.formats), kRaw720);
  // JPEG does not have this size.
  EXPECT_EQ(completedFormat({"", 640, 480, 0.0}, device.formats),
            (DeviceFormat{"YUYV", 640, 480, 30.0}));
  EXPECT_EQ(completedFormat({"NV12", 0, 0, 0.0}, device.formats),
            (DeviceFormat{"NV12", 0, 0, 0.0}));
  EXPECT_EQ(completedFormat({}, {}), DeviceFormat{});
}

TEST(CameraFormats, KnowsWhatIsOffered) {
  const CameraDevice device = webcamAt(1);
  EXPECT_TRUE(isOffered({}, device.formats));
  EXPECT_TRUE(isOffered(kRaw720, device.formats));
  EXPECT_TRUE(isOffered({"", 1280, 720, 29.97}, device.formats)); // drivers round
  EXPECT_TRUE(isOffered({"MJPG", 0, 0, 30.0}, device.formats));
  EXPECT_FALSE(isOffered({"MJPG", 640, 480, 0.0}, device.formats));
  EXPECT_FALSE(isOffered({"YUYV", 1280, 720, 60.0}, device.formats));
  EXPECT_FALSE(isOffered({"H264", 0, 0, 0.0}, device.formats));
}

TEST(CameraFormats, AreDescribed) {
  EXPECT_EQ(describe(kRaw720), "YUYV 1280x720 30");
  EXPECT_EQ(describe(DeviceFormat{"", 640, 480, 7.5}), "640x480 7.5");
  EXPECT_EQ(describe(DeviceIdentity{"bus", "A", "Webcam", ""}), "'Webcam' (serial number A)");
  EXPECT_EQ(describe(DeviceIdentity{"bus", "", "Webcam", ""}), "'Webcam' (connector bus)");
}

} // namespace
} // namespace dewpoint::tests
