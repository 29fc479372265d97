// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <map>
#include <string>

namespace dewpoint::capture {

/// Properties by which a camera device is recognized, even after it was unplugged or the computer
/// was restarted (see devices/device_match.h). Unknown properties are empty.
struct DeviceIdentity {
  /// Connector to which the device is plugged in, named as below /dev/v4l/by-path, for example
  /// "pci-0000:00:14.0-usb-0:3:1.0". The suffix "-video-index0" is omitted; any other suffix is
  /// kept.
  std::string bus;
  std::string serial;             ///< serial number in the USB descriptor
  std::string name;               ///< product name, for example "HD Pro Webcam C920"
  std::string vendorAndProductId; ///< USB vendor and product number, hexadecimal: "046d:082d"

  bool isEmpty() const {
    return bus.empty() && serial.empty() && name.empty() && vendorAndProductId.empty();
  }
  bool operator==(const DeviceIdentity&) const = default;
};

/// Requested format of a device's images, before any rotation. The device chooses the values that
/// are empty or 0.
struct DeviceFormat {
  std::string pixelFormat; ///< V4L2 four-character code without trailing spaces: "MJPG", "YUYV"
  int width = 0;           ///< pixels; either both width and height are 0, or neither is
  int height = 0;          ///< pixels
  double frameRate = 0.0;  ///< images per second

  bool operator==(const DeviceFormat&) const = default;
};

/// Values of camera controls (V4L2) by name, for example {"exposure_time_absolute", 157}.
using ControlValues = std::map<std::string, std::int64_t, std::less<>>;

/// Settings of a camera's device that a project stores.
struct DeviceSettings {
  DeviceIdentity identity;
  DeviceFormat format;
  ControlValues controls; ///< values that are set each time the device is opened

  bool operator==(const DeviceSettings&) const = default;
};

} // namespace dewpoint::capture
