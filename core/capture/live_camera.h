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
  int rotateDegrees = 0; ///< clockwise rotation of the images: 0, 90, 180 or 270 degrees
  /// Expected size of the images after rotation and cropping, pixels; 0: the size of the first
  /// image.
  int width = 0;
  int height = 0;
  bool isMirrored = false; ///< true if left and right are swapped after the rotation
  /// Additional time, compared to the other cameras, from the exposure of an image to its arrival;
  /// seconds.
  double delaySeconds = 0.0;
  /// Settings of a V4L2 device: its identity, the format to request, and the controls to set. The
  /// device is found by its identity, wherever it is plugged in. If the identity is empty, the
  /// device at `location` is used.
  DeviceSettings device = {};
  ImageMargins crop = {}; ///< margins that are cut off after rotation and mirroring

  /// Returns the expected width of the images that the camera sends, before rotation and cropping;
  /// pixels; 0 if unknown.
  int sentWidth() const { return isUpright() ? uncroppedWidth() : uncroppedHeight(); }
  /// Returns the expected height of the images that the camera sends, before rotation and cropping;
  /// pixels; 0 if unknown.
  int sentHeight() const { return isUpright() ? uncroppedHeight() : uncroppedWidth(); }

private:
  bool isUpright() const { return rotateDegrees % 180 == 0; }
  int uncroppedWidth() const { return width > 0 ? width + crop.width() : 0; }
  int uncroppedHeight() const { return height > 0 ? height + crop.height() : 0; }
};

} // namespace dewpoint::capture
