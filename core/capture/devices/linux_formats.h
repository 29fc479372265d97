// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/devices/camera_device.h"
#include "core/capture/devices/linux_calls.h"

#include <vector>

namespace dewpoint::capture {

/// Returns the formats of a V4L2 capture device, in the driver's order. If the driver accepts a
/// range of sizes or rates, returns the two ends of the range and the common values in it.
std::vector<OfferedFormat> readLinuxFormats(LinuxNode& node);

} // namespace dewpoint::capture
