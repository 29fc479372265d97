// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/device_settings.h"
#include "core/geometry/image_margins.h"

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
  /// Expected size of the images after rotation and cropping, pixels; 0: that of the first image.
  int width = 0;
  int height = 0;
  bool mirrored = false; ///< left and right are swapped after the rotation
  /// How much longer an image of this camera takes from the scene to its arrival than an image of
  /// the other cameras; seconds.
  double delay = 0.0;
  /// For V4L2 devices: the identity, by which the device is found wherever it is plugged in
  /// (`location` is used if it is empty), the format to request, and controls to set.
  DeviceSettings device = {};
  ImageMargins crop = {}; ///< cut off after rotation and mirroring

  /// Return the expected width and height of the images as the camera sends them, before rotation
  /// and cropping, in pixels; 0 if unknown.
  int sentWidth() const { return isUpright() ? uncroppedWidth() : uncroppedHeight(); }
  int sentHeight() const { return isUpright() ? uncroppedHeight() : uncroppedWidth(); }

private:
  bool isUpright() const { return rotateDegrees % 180 == 0; }
  int uncroppedWidth() const { return width > 0 ? width + crop.width() : 0; }
  int uncroppedHeight() const { return height > 0 ? height + crop.height() : 0; }
};

} // namespace dewpoint::capture
