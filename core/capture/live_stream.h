// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/live_camera.h"

#include <opencv2/core/mat.hpp>

#include <functional>
#include <memory>
#include <string>

namespace dewpoint::capture {

/// One connection to a device, used by one thread only. Any call may take long.
class LiveStream {
public:
  virtual ~LiveStream() = default;
  /// Connects; the error's detail tells why it failed.
  virtual tl::expected<void, std::string> open() = 0;
  /// Waits for the next picture; false when the connection is lost.
  virtual bool grab() = 0;
  /// The picture just grabbed, in memory of its own; empty when it cannot be decoded.
  virtual cv::Mat retrieve() = 0;
};

using LiveStreamPtr = std::unique_ptr<LiveStream>;
/// Makes an unopened connection; called by the camera's thread before each attempt.
using LiveStreamFactory = std::function<LiveStreamPtr(const LiveCamera&)>;

/// Whether the location is of a kind this program knows.
Status checkLocation(const LiveCamera& camera);

/// The connection through OpenCV that fits the camera's location.
LiveStreamPtr makeVideoStream(const LiveCamera& camera);

} // namespace dewpoint::capture
