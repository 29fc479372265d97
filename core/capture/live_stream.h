// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/live_camera.h"

#include <opencv2/core/mat.hpp>

#include <functional>
#include <memory>
#include <string>

namespace dewpoint::capture {

/// A connection to one device, used by one thread only. Any call may take a long time.
class LiveStream {
public:
  virtual ~LiveStream() = default;
  /// Connects to the device. The error text says why it failed.
  virtual tl::expected<void, std::string> open() = 0;
  /// Waits for the next image; false if the connection is lost.
  virtual bool grab() = 0;
  /// Image that was just grabbed, in memory of its own; empty if it cannot be decoded.
  virtual cv::Mat retrieve() = 0;
};

using LiveStreamPtr = std::unique_ptr<LiveStream>;
/// Creates an unopened connection. The camera's thread calls it before each attempt to connect.
using LiveStreamFactory = std::function<LiveStreamPtr(const LiveCamera&)>;

/// Checks whether the location is of a kind that this program knows.
Status checkLocation(const LiveCamera& camera);

/// Creates the OpenCV connection for the camera's location.
LiveStreamPtr makeVideoStream(const LiveCamera& camera);

} // namespace dewpoint::capture
