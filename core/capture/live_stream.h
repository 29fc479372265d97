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

/// Connection to one camera, used by one thread only. Calls may block for a long time if the
/// library in use has no time-out.
class LiveStream {
public:
  virtual ~LiveStream() = default;
  /// Connects to the device. The error message contains the reason for a failure.
  virtual tl::expected<void, std::string> open() = 0;
  /// Waits for the next image and holds it for retrieve(). Returns false if the connection is lost.
  virtual bool grab() = 0;
  /// Returns the image that was grabbed last, in memory of its own. The image is empty if it cannot
  /// be decoded.
  virtual cv::Mat retrieve() = 0;
  /// Returns the capture time of the image that was grabbed last, or nothing if the device does not
  /// report it. Capture times increase from image to image.
  virtual std::optional<CaptureInstant> captureTime() const { return std::nullopt; }
  /// Returns when the data of the image that was grabbed last arrived, before decoding; nothing if
  /// this is not known.
  virtual std::optional<std::chrono::steady_clock::time_point> arrivalTime() const {
    return std::nullopt;
  }
  /// Returns why grab() returned false, as text to append after a colon; empty if the reason is not
  /// known.
  virtual std::string lostReason() const { return {}; }
  /// Returns a problem of the device that does not prevent it from delivering images, such as a
  /// control that could not be set. The text can be appended after a colon. It is empty if there is
  /// no problem, and does not change while the connection is open.
  virtual std::string warning() const { return {}; }
  /// Returns whether the source has delivered all its images, so that there is no point in opening
  /// it again.
  virtual bool hasEnded() const { return false; }
};

using LiveStreamPtr = std::unique_ptr<LiveStream>;
/// Function that creates an unopened connection. The camera's thread calls it before each attempt
/// to connect.
using LiveStreamFactory = std::function<LiveStreamPtr(const LiveCamera&)>;

/// Creates a connection that uses OpenCV: to a V4L2 device given by its number, or through FFmpeg
/// to a network address. The connection does not report capture times, so the time of arrival is
/// used.
LiveStreamPtr makeVideoStream(const LiveCamera& camera);

} // namespace dewpoint::capture
