// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/live_camera.h"

#include <opencv2/core/mat.hpp>

#include <functional>
#include <memory>
#include <string>

namespace dewpoint::capture {

/// Connection to one device, used by one thread only. Any call may block for a long time.
class LiveStream {
public:
  virtual ~LiveStream() = default;
  /// Connects to the device. The error message contains the reason for a failure.
  virtual tl::expected<void, std::string> open() = 0;
  /// Waits for the next image. Returns false if the connection is lost.
  virtual bool grab() = 0;
  /// Returns the image that was just grabbed, in its own memory; empty if it cannot be decoded.
  virtual cv::Mat retrieve() = 0;
};

using LiveStreamPtr = std::unique_ptr<LiveStream>;
/// Function that creates an unopened connection. The camera's thread calls it before each attempt
/// to connect.
using LiveStreamFactory = std::function<LiveStreamPtr(const LiveCamera&)>;

/// Checks whether the program supports this type of location.
Status checkLocation(const LiveCamera& camera);

/// Creates the OpenCV connection for the camera's location.
LiveStreamPtr makeVideoStream(const LiveCamera& camera);

} // namespace dewpoint::capture
