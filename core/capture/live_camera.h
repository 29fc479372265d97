// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>

namespace dewpoint::capture {

/// One camera that delivers pictures as they happen.
struct LiveCamera {
  std::string name;
  /// A number or /dev/videoN (V4L2), a URL such as http://host/stream or rtsp://... (FFmpeg), or
  /// "gst:" and a GStreamer pipeline that ends in an appsink.
  std::string location;
  int rotateDegrees = 0; ///< clockwise: 0, 90, 180 or 270
  int width = 0;         ///< expected after the rotation, pixels; 0: that of the first picture
  int height = 0;        ///< expected after the rotation, pixels; 0: that of the first picture
  bool mirrored = false; ///< left to right, after the rotation
  double delay = 0.0;    ///< seconds from what a picture shows to its grab, beyond the others'
};

} // namespace dewpoint::capture
