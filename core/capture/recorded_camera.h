// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"
#include "core/geometry/image_margins.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <functional>
#include <string>

namespace dewpoint::capture {

/// One camera in a recording: a video file, a folder of images, or a function that generates
/// images.
struct RecordedCamera {
  enum class Kind { Video, Images, Generated };

  std::string name;
  Kind kind = Kind::Video;
  std::string path;      ///< path of the video or folder; not used for generated images
  int rotateDegrees = 0; ///< clockwise rotation of the images: 0, 90, 180 or 270 degrees
  int width = 0;         ///< expected width after rotation and cropping, pixels; 0: any
  int height = 0;        ///< expected height after rotation and cropping, pixels; 0: any
  /// Function that returns a new CV_8UC3 image for a frame number.
  std::function<cv::Mat(std::int64_t)> generate;
  std::int64_t generatedFrameCount = 0; ///< number of generated images
  bool isMirrored = false;              ///< true if left and right are swapped after the rotation
  /// Path of the file with a table of capture times (readCaptureTimes()). Empty if images are
  /// evenly spaced at the frame rate of the recording. Either all cameras have such a file or none.
  std::string timesFile;
  /// Delay in seconds. Without capture times, image k shows the scene as it was (k / rate -
  /// delaySeconds) seconds after the start.
  double delaySeconds = 0.0;
  ImageMargins crop = {}; ///< margins that are cut off after rotation and mirroring
};

} // namespace dewpoint::capture
