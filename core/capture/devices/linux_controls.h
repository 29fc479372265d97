// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/devices/device_control.h"
#include "core/capture/devices/linux_calls.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dewpoint::capture {

/// Returns the controls of a V4L2 device: numbers, switches and menus whose values can be read.
std::vector<DeviceControl> linuxControls(LinuxNode& node);

/// Sets a control; see DeviceAccess::setControl(). `path` is for the error.
Status setLinuxControl(LinuxNode& node, const std::string& path, const std::string& name,
                       std::int64_t value);

/// Returns an error number as text after a colon.
std::string systemReason(int errorNumber);

} // namespace dewpoint::capture
