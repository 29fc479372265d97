// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/live_camera.h"

#include <optional>
#include <string>
#include <string_view>

namespace dewpoint::capture {

/// Returns the format that is requested from a V4L2 device. It is the format in the camera's device
/// settings. If this format has no size, the size of the camera's images before rotation and
/// cropping is used.
DeviceFormat requestedFormat(const LiveCamera& camera);

/// Returns the GStreamer caps (a format description) for the format that is requested from the
/// camera's device (requestedFormat()). If this format has no pixel format, the caps ask for JPEG,
/// or else for uncompressed images. Returns nothing if GStreamer has no caps for the pixel format.
std::optional<std::string> deviceCaps(const LiveCamera& camera);

/// Returns whether decoding an image in this V4L2 pixel format requires previous images.
bool isInterCoded(std::string_view pixelFormat);

} // namespace dewpoint::capture
