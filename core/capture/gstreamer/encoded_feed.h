// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/gstreamer/pre_roll.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

namespace dewpoint::capture {

/// Passes the images of one camera from its connection to a recording, without decoding them. It
/// outlives the connection, so a recording continues after the camera was connected again. While
/// there is no receiver, it can keep the latest images (setPreRoll()). Thread-safe.
class EncodedFeed {
public:
  using Clock = std::chrono::steady_clock;
  /// Function that is called for each image, in a thread of the stream. It must not block.
  using Receiver = std::function<void(const EncodedImage&)>;

  /// Passes an image to the receiver. Without a receiver, keeps it among the latest images
  /// (pre-roll).
  void put(const EncodedImage& image);
  /// Reports that the stream has ended, and drops the images that were kept (pre-roll). The stream
  /// begins again with the next image.
  void markEnded();

  /// Sets how many of the latest images are kept while there is no receiver (pre-roll). Drops the
  /// images kept so far. With a length of 0, no images are kept.
  void setPreRoll(const PreRollLimits& limits);
  /// Returns the number, duration and size of the images that are kept while there is no receiver
  /// (pre-roll).
  PreRollStatus preRoll() const;
  /// Returns the capture time of the oldest image that is kept while there is no receiver
  /// (pre-roll), or nothing if no image is kept.
  std::optional<Clock::time_point> preRollBegin() const;

  /// Replaces the receiver. The new receiver first gets the latest images, which were kept
  /// (pre-roll), then all new images.
  void connect(Receiver receiver);
  /// Removes the receiver. It is not called after this function has returned.
  void disconnect();

  /// Returns the number of images passed to put() so far.
  std::int64_t imageCount() const;
  /// Returns the time at which the stream ended, or nothing if it has not ended or has begun again.
  std::optional<Clock::time_point> endTime() const;

private:
  mutable std::mutex mutex_;
  Receiver receiver_;
  std::optional<PreRoll> preRoll_;
  std::int64_t images_ = 0;
  std::optional<Clock::time_point> endTime_;
};

using EncodedFeedPtr = std::shared_ptr<EncodedFeed>;

} // namespace dewpoint::capture
