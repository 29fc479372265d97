// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/devices/device_control.h"
#include "core/capture/devices/linux_calls.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dewpoint::capture {

/// Returns the controls of a V4L2 device whose values can be read: numbers, switches and menus.
std::vector<DeviceControl> readLinuxControls(LinuxNode& node);

/// Sets a control; see DeviceAccess::setControl(). `path` is the path of the device for error
/// messages.
Status setLinuxControl(LinuxNode& node, const std::string& path, const std::string& name,
                       std::int64_t value);

/// Returns a description of a system error number, as text to append after a colon.
std::string systemErrorText(int errorNumber);

} // namespace dewpoint::capture
