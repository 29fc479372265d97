// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/device_settings.h"

#include <string>

namespace dewpoint::capture {

/// Camera that delivers live images.
struct LiveCamera {
  std::string name;
  /// Camera number, /dev/videoN or another path below /dev (V4L2), URL such as http://host/stream
  /// or rtsp://..., "gst:" followed by a GStreamer pipeline, or "test:" followed by the name of a
  /// test pattern (see gstreamer/pipeline_text.h).
  std::string location;
  int rotateDegrees = 0; ///< clockwise: 0, 90, 180 or 270
  int width = 0;         ///< expected after the rotation, pixels; 0: width of the first image
  int height = 0;        ///< expected after the rotation, pixels; 0: height of the first image
  bool mirrored = false; ///< left and right are swapped after the rotation
  /// How much longer an image of this camera takes from the scene to its arrival than an image of
  /// the other cameras; seconds.
  double delay = 0.0;
  /// For V4L2 devices: the identity, by which the device is found wherever it is plugged in
  /// (`location` is used if it is empty), the format to request, and controls to set.
  DeviceSettings device = {};
};

} // namespace dewpoint::capture
