// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/devices/camera_device.h"
#include "core/capture/devices/linux_calls.h"

#include <vector>

namespace dewpoint::capture {

/// Returns the formats of a V4L2 capture device, in the driver's order. Where the driver accepts
/// ranges of sizes or rates, the usual ones in the range are returned, and its ends.
std::vector<OfferedFormat> linuxFormats(LinuxNode& node);

} // namespace dewpoint::capture
