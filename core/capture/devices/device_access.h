// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/devices/camera_device.h"
#include "core/capture/devices/device_control.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace dewpoint::capture {

/// Access to the camera devices of a computer. Thread-safe. Calls may take long, because they wait
/// for the drivers. Do not call them from the thread of a window.
class DeviceAccess {
public:
  virtual ~DeviceAccess() = default;

  /// Returns all devices that deliver images, ordered by device number. Device nodes for metadata,
  /// codecs and outputs are omitted.
  virtual std::vector<CameraDevice> listDevices() = 0;

  /// Returns a text that changes when a device is connected or disconnected, or when its links in
  /// /dev/v4l change. Opens no device.
  virtual std::string deviceListSignature() = 0;

  /// Returns the controls of the device at this path or address, in the driver's order. Error:
  /// DeviceUnavailable; Error::file is the path.
  virtual Result<std::vector<DeviceControl>> readControls(const std::string& path) = 0;

  /// Sets the control `name` of a device. The driver rounds values between two steps. Errors:
  /// DeviceUnavailable; NotFound if the device has no such control; BadValue if the device refuses
  /// the value. Error::field is the name of the control.
  virtual Status setControl(const std::string& path, const std::string& name,
                            std::int64_t value) = 0;
};

using DeviceAccessPtr = std::shared_ptr<DeviceAccess>;

/// Returns access to the devices of this computer: V4L2 devices on Linux, no devices on other
/// systems.
DeviceAccessPtr systemDevices();

} // namespace dewpoint::capture
