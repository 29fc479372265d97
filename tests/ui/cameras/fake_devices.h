// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/devices/device_access.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::tests::test {

/// Returns a webcam whose images are a test pattern.
inline capture::CameraDevice fakeWebcam(int number, const std::string& serial) {
  capture::CameraDevice device;
  device.path = "/dev/video" + std::to_string(40 + number);
  device.stablePath = "test:ball?width=320&height=240&rate=" + std::to_string(10 + number);
  device.identity = {"usb-0:" + std::to_string(number) + ":1.0", serial, "Fake webcam",
                     "1234:5678"};
  device.usbLink = {1, 480.0, 480.0};
  device.formats = {{"MJPG", "Motion-JPEG", true, {{1920, 1080, {30.0}}, {320, 240, {30.0, 15.0}}}},
                    {"YUYV", "YUYV 4:2:2", false, {{1920, 1080, {30.0, 5.0}}, {320, 240, {30.0}}}}};
  return device;
}

/// Devices that are plugged in and unplugged by a test, each with an automatic exposure that is on.
class FakeDevices final : public capture::DeviceAccess {
public:
  void plug(const capture::CameraDevice& device) {
    const std::scoped_lock lock(mutex_);
    devices_.push_back(device);
    values_[device.path] = {{"auto_exposure", 3}, {"exposure_time_absolute", 250}, {"gain", 64}};
    ++changes_;
  }
  void unplug(const std::string& serial) {
    const std::scoped_lock lock(mutex_);
    std::erase_if(devices_, [&](const auto& device) { return device.identity.serial == serial; });
    ++changes_;
  }
  std::int64_t value(const std::string& path, const std::string& name) {
    const std::scoped_lock lock(mutex_);
    return values_[path][name];
  }

  std::vector<capture::CameraDevice> listDevices() override {
    const std::scoped_lock lock(mutex_);
    return devices_;
  }
  std::string deviceListSignature() override {
    const std::scoped_lock lock(mutex_);
    return std::to_string(changes_);
  }
  Result<std::vector<capture::DeviceControl>> readControls(const std::string& path) override {
    const std::scoped_lock lock(mutex_);
    if (!isPlugged(path)) {
      return failure(ErrorCode::DeviceUnavailable, path, "", "it is unplugged");
    }
    auto& now = values_[path];
    const bool automatic = now["auto_exposure"] != 1;
    return std::vector<capture::DeviceControl>{{"auto_exposure",
                                                "Auto Exposure",
                                                capture::ControlKind::Menu,
                                                0,
                                                3,
                                                1,
                                                3,
                                                now["auto_exposure"],
                                                {{1, "Manual Mode"}, {3, "Aperture Priority Mode"}},
                                                false,
                                                false},
                                               {"exposure_time_absolute",
                                                "Exposure Time, Absolute",
                                                capture::ControlKind::Integer,
                                                3,
                                                2047,
                                                1,
                                                250,
                                                now["exposure_time_absolute"],
                                                {},
                                                false,
                                                automatic},
                                               {"gain",
                                                "Gain",
                                                capture::ControlKind::Integer,
                                                0,
                                                255,
                                                1,
                                                64,
                                                now["gain"],
                                                {},
                                                false,
                                                false}};
  }
  Status setControl(const std::string& path, const std::string& name, std::int64_t value) override {
    const std::scoped_lock lock(mutex_);
    if (!isPlugged(path)) {
      return failure(ErrorCode::DeviceUnavailable, path, "", "it is unplugged");
    }
    if (!values_[path].contains(name)) {
      return failure(ErrorCode::NotFound, path, name, "");
    }
    values_[path][name] = value;
    return {};
  }

private:
  bool isPlugged(const std::string& path) const {
    return std::ranges::any_of(devices_, [&](const auto& one) { return one.path == path; });
  }

  std::mutex mutex_;
  std::vector<capture::CameraDevice> devices_;
  std::map<std::string, std::map<std::string, std::int64_t>> values_;
  int changes_ = 0;
};

} // namespace dewpoint::tests::test
