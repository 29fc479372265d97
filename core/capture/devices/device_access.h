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

/// The camera devices of a computer. Calls may come from several threads at once. A call lasts as
/// long as the drivers need, so that it has no place in the thread of the window.
class DeviceAccess {
public:
  virtual ~DeviceAccess() = default;

  /// Returns all devices that deliver images, ordered by device number. Nodes for metadata, codecs
  /// and outputs are left out.
  virtual std::vector<CameraDevice> list() = 0;

  /// Returns a text that changes when a device comes, goes, or gets other links in /dev/v4l. No
  /// device is opened for it.
  virtual std::string signature() = 0;

  /// Returns the controls of the device at this path or address, in the driver's order. Errors:
  /// DeviceUnavailable with the path as file.
  virtual Result<std::vector<DeviceControl>> controls(const std::string& path) = 0;

  /// Sets a control. Values between two steps are rounded by the driver. Errors: DeviceUnavailable;
  /// NotFound if the device has no such control; BadValue if it refuses the value. `field` is the
  /// name of the control.
  virtual Status setControl(const std::string& path, const std::string& name,
                            std::int64_t value) = 0;
};

using DeviceAccessPtr = std::shared_ptr<DeviceAccess>;

/// Returns the devices of this computer: V4L2 on Linux, none on other systems.
DeviceAccessPtr systemDevices();

} // namespace dewpoint::capture
