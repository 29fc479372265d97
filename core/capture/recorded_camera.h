// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <functional>
#include <string>

namespace dewpoint::capture {

/// One camera of a recording: a video file, a folder of pictures, or a function that makes them.
struct RecordedCamera {
  enum class Kind { Video, Images, Generated };

  std::string name;
  Kind kind = Kind::Video;
  std::string path;      ///< of the video or the folder; unused when generated
  int rotateDegrees = 0; ///< clockwise: 0, 90, 180 or 270
  int width = 0;         ///< expected after the rotation, pixels; 0: any
  int height = 0;        ///< expected after the rotation, pixels; 0: any
  std::function<cv::Mat(std::int64_t)> generate; ///< a fresh CV_8UC3 picture of that frame number
  std::int64_t generatedFrames = 0;
  bool mirrored = false; ///< left to right, after the rotation
  /// A table of when its pictures were taken (readCaptureTimes()); empty: evenly, at the rate of
  /// the recording. All cameras have one or none.
  std::string times;
  /// Seconds by which its pictures are late: picture k shows what was k / rate - delay seconds
  /// after the beginning.
  double delay = 0.0;
};

} // namespace dewpoint::capture
