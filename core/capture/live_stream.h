// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/capture_instant.h"
#include "core/capture/live_camera.h"

#include <opencv2/core/mat.hpp>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace dewpoint::capture {

/// Connection to one device, used by one thread only. A call may block for a long time where the
/// library in use has no time-out.
class LiveStream {
public:
  virtual ~LiveStream() = default;
  /// Connects to the device. The error message contains the reason for a failure.
  virtual tl::expected<void, std::string> open() = 0;
  /// Waits for the next image. Returns false if the connection is lost.
  virtual bool grab() = 0;
  /// Returns the image that was just grabbed, in its own memory; empty if it cannot be decoded.
  virtual cv::Mat retrieve() = 0;
  /// Returns the capture time of the image that was just grabbed, or nothing if the device does not
  /// report it. Capture times increase.
  virtual std::optional<CaptureInstant> captureTime() const { return std::nullopt; }
  /// Returns when the data of the image that was just grabbed arrived, before they were decoded, or
  /// nothing if that is not known.
  virtual std::optional<std::chrono::steady_clock::time_point> arrivalTime() const {
    return std::nullopt;
  }
  /// Returns why grab() returned false, in words that follow a colon; empty if unknown.
  virtual std::string lostReason() const { return {}; }
  /// Returns whether the source has delivered all its images, so that there is no point in opening
  /// it again.
  virtual bool hasEnded() const { return false; }
};

using LiveStreamPtr = std::unique_ptr<LiveStream>;
/// Function that creates an unopened connection. The camera's thread calls it before each attempt
/// to connect.
using LiveStreamFactory = std::function<LiveStreamPtr(const LiveCamera&)>;

/// Creates the OpenCV connection for the camera's location: a V4L2 device by its number, or a
/// network address through FFmpeg. The images are decoded, and their time is that of their arrival.
LiveStreamPtr makeVideoStream(const LiveCamera& camera);

} // namespace dewpoint::capture
