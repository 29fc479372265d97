// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/live_camera.h"

#include <optional>
#include <string>
#include <string_view>

namespace dewpoint::capture {

/// Returns the format that is requested from a V4L2 device: that in the camera's device settings;
/// where it leaves the size open, with that of the camera before its rotation.
DeviceFormat requestedFormat(const LiveCamera& camera);

/// Returns the caps that are requested from a V4L2 device: those of requestedFormat(); where it
/// leaves the pixel format open, JPEG before uncompressed images. Returns nothing if GStreamer
/// has no caps for the pixel format.
std::optional<std::string> deviceCaps(const LiveCamera& camera);

/// Returns whether images in this V4L2 pixel format depend on those before them.
bool isInterCoded(std::string_view pixelFormat);

} // namespace dewpoint::capture
