// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <map>
#include <string>

namespace dewpoint::capture {

/// What distinguishes one camera device from all others, also after it was unplugged or the
/// computer was restarted (see devices/device_match.h). Text is empty where it is not known.
struct DeviceIdentity {
  /// Connector, as udev names it below /dev/v4l/by-path, for example
  /// "pci-0000:00:14.0-usb-0:3:1.0". The end "-video-index0" is left out; another index is kept.
  std::string bus;
  std::string serial;        ///< serial number in the USB descriptor
  std::string name;          ///< product name, for example "HD Pro Webcam C920"
  std::string vendorProduct; ///< of USB, four hexadecimal digits each: "046d:082d"

  bool isEmpty() const {
    return bus.empty() && serial.empty() && name.empty() && vendorProduct.empty();
  }
  bool operator==(const DeviceIdentity&) const = default;
};

/// Requested format of a device's images, before any rotation. What is empty or 0 is left to the
/// device.
struct DeviceFormat {
  std::string pixelFormat; ///< V4L2 four-character code without spaces at its end: "MJPG", "YUYV"
  int width = 0;           ///< pixels; 0 exactly if height is 0
  int height = 0;          ///< pixels
  double rate = 0.0;       ///< images per second

  bool operator==(const DeviceFormat&) const = default;
};

/// Values of V4L2 controls by name, for example {"exposure_time_absolute", 157}.
using ControlValues = std::map<std::string, std::int64_t, std::less<>>;

/// What a project stores about the device of a camera.
struct DeviceSettings {
  DeviceIdentity identity;
  DeviceFormat format;
  ControlValues controls; ///< set whenever the device is opened

  bool operator==(const DeviceSettings&) const = default;
};

} // namespace dewpoint::capture
