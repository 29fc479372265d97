// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/devices/camera_device.h"
#include "core/capture/devices/device_control.h"
#include "core/project/project.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// Connected device, with its controls, for a list of devices.
struct ListedDevice {
  CameraDevice device;
  /// Controls of the device; not set: controls are not listed.
  std::optional<std::vector<DeviceControl>> controls = {};
};

/// Returns a human-readable list of devices, with several lines per device. Empty if there are no
/// devices.
std::string deviceListText(std::span<const ListedDevice> devices);

/// Returns an indented JSON array with one object per device. Bytes that are not valid UTF-8 are
/// replaced.
std::string deviceListJson(std::span<const ListedDevice> devices);

/// Stores the identities of connected devices in a project. For each camera whose device has no
/// identity yet, stores the identity and the stable address of the device at the camera's location.
/// Returns the number of cameras that got an identity.
std::size_t identifyDevices(Project& project, std::span<const CameraDevice> devices);

} // namespace dewpoint::setup
