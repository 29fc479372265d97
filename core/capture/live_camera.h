// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>

namespace dewpoint::capture {

/// A camera that delivers images live.
struct LiveCamera {
  std::string name;
  /// A number or /dev/videoN (V4L2), a URL such as http://host/stream or rtsp://... (FFmpeg), or
  /// "gst:" and a GStreamer pipeline that ends in an appsink.
  std::string location;
  int rotateDegrees = 0; ///< clockwise: 0, 90, 180 or 270
  int width = 0;         ///< expected after the rotation, pixels; 0: width of the first image
  int height = 0;        ///< expected after the rotation, pixels; 0: height of the first image
  bool mirrored = false; ///< left and right are swapped, after the rotation
  double delay = 0.0;    ///< seconds between the scene an image shows and its grab, beyond those of
                         ///< the other cameras
};

} // namespace dewpoint::capture
