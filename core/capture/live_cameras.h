// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/frame_source.h"

#include <memory>
#include <string>
#include <vector>

namespace dewpoint::capture {

/// One camera that delivers pictures as they happen.
struct LiveCamera {
  std::string name;
  /// A number or /dev/videoN (V4L2), a URL such as http://host/stream or rtsp://... (FFmpeg), or
  /// "gst:" and a GStreamer pipeline that ends in an appsink.
  std::string location;
  int rotateDegrees = 0; ///< clockwise: 0, 90, 180 or 270
  int width = 0;         ///< expected after the rotation, pixels; 0: any
  int height = 0;        ///< expected after the rotation, pixels; 0: any
  bool mirrored = false; ///< left to right, after the rotation
  double delay = 0.0;    ///< seconds from what a picture shows to its grab, beyond the others'
};

/// Starts one thread per camera, each opening, reading and reconnecting on its own, and returns at
/// once: only settings that can never work (an empty or unknown location, a rotation that is no
/// multiple of 90) fail. A camera that cannot be opened (DeviceUnavailable), stopped delivering
/// (ConnectionLost) or sends another picture size (Mismatch) is a notice for as long as that lasts.
/// Frames carry the steady clock's reading right after the grab, counted from this call, less what
/// of their camera's delay.
Result<std::unique_ptr<FrameSetSource>> openLive(const std::vector<LiveCamera>& cameras);

} // namespace dewpoint::capture
