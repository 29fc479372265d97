// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/devices/camera_device.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::capture {

/// What sysfs knows about a node. Text is empty where it knows nothing.
struct SysfsFacts {
  int index = 0;             ///< of the node among those of its device
  std::string product;       ///< of the USB descriptor
  std::string serial;        ///< of the USB descriptor
  std::string vendorProduct; ///< "046d:082d"
  UsbLink usb;
};

/// Returns the names of all video nodes ("video0", ...), by number. `root`: see LinuxDevices.
std::vector<std::string> videoNodes(const std::filesystem::path& root);

SysfsFacts sysfsFacts(const std::filesystem::path& root, const std::string& node);

/// Returns the first link in a folder (such as "dev/v4l/by-path") that leads to a node; only its
/// name, without the folder. Empty if there is none.
std::string linkTo(const std::filesystem::path& root, const std::string& folder,
                   const std::string& node);

} // namespace dewpoint::capture
