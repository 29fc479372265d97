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

/// A connected device, as it is listed.
struct ListedDevice {
  CameraDevice device;
  std::optional<std::vector<DeviceControl>> controls = {}; ///< nothing: not to be listed
};

/// Returns devices as text for people, several lines each. Empty if there are none.
std::string deviceListText(std::span<const ListedDevice> devices);

/// Returns devices as a JSON array with one object each, indented. Bytes that are not valid UTF-8
/// are replaced.
std::string deviceListJson(std::span<const ListedDevice> devices);

/// Gives each camera of a project that has a device but no identity the identity and the stable
/// address of the device that is connected at its location. Returns how many cameras got one.
std::size_t identifyDevices(Project& project, std::span<const CameraDevice> devices);

} // namespace dewpoint::setup
