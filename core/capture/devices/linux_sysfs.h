// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/devices/camera_device.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::capture {

/// Properties of a video device node, read from sysfs. Unknown texts are empty.
struct SysfsFacts {
  int nodeIndex = 0;              ///< index of the node among the nodes of its device
  std::string product;            ///< product name in the USB descriptor
  std::string serial;             ///< serial number in the USB descriptor
  std::string vendorAndProductId; ///< USB vendor and product number, hexadecimal: "046d:082d"
  UsbLink usbLink;
};

/// Returns the names of all video device nodes ("video0", ...), ordered by number. `root` is the
/// folder that contains sys, usually "/".
std::vector<std::string> listVideoNodes(const std::filesystem::path& root);

/// Returns the properties of a video device node ("video0"). `root` is the folder that contains
/// sys, usually "/".
SysfsFacts readSysfsFacts(const std::filesystem::path& root, const std::string& node);

/// Returns the name of the first link to a node in a folder such as "dev/v4l/by-path" below `root`.
/// The name does not include the folder. It is empty if there is no such link.
std::string sysfsLinkTarget(const std::filesystem::path& root, const std::string& folder,
                            const std::string& node);

} // namespace dewpoint::capture
