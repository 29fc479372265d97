// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/frame_source.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

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
  /// Seconds by which its pictures are late: picture k shows what was k / rate - delay seconds
  /// after the beginning.
  double delay = 0.0;
};

/// Opens synchronized recordings: frame k of each camera shows the same instant, k / rate seconds
/// after the first. Of a camera that is late the picture nearest in time is taken, with its own
/// capture time; before its first and after its last one there is none. `framesPerSecond` 0 takes
/// the first video's own rate, else 30. Seeking is exact to the frame. Cameras of different length
/// give the shortest's frame count and one notice.
Result<std::unique_ptr<FrameSetSource>> openRecording(const std::vector<RecordedCamera>& cameras,
                                                      double framesPerSecond);

} // namespace dewpoint::capture
