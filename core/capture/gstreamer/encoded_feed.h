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

/// Passes the images of one camera, as they come, from its connection to a recording. It outlives
/// the connection, so that a recording continues after the camera was connected again. While nobody
/// receives the images, it keeps the last ones on request. All functions may be called from any
/// thread.
class EncodedFeed {
public:
  using Clock = std::chrono::steady_clock;
  /// Called for each image in a thread of the stream; must not block.
  using Receiver = std::function<void(const EncodedImage&)>;

  /// Passes on an image.
  void put(const EncodedImage& image);
  /// Reports that the stream has ended. It begins again with the next image.
  void setEnded();

  /// Keeps the last images while there is no receiver. A length of 0 keeps nothing.
  void setPreRoll(const PreRollLimits& limits);
  PreRollStatus preRoll() const;
  /// Returns when the oldest image that is kept was captured; nothing without one.
  std::optional<Clock::time_point> preRollBegin() const;

  /// Makes `receiver` get the images that are kept and then all images from now on, instead of the
  /// one before.
  void connect(Receiver receiver);
  /// Ends this; the receiver is not called after this function has returned.
  void disconnect();

  /// Returns the number of images so far.
  std::int64_t imageCount() const;
  /// Returns since when the stream has been at its end; nothing while it is not.
  std::optional<Clock::time_point> endedSince() const;

private:
  mutable std::mutex mutex_;
  Receiver receiver_;
  std::optional<PreRoll> preRoll_;
  std::int64_t images_ = 0;
  std::optional<Clock::time_point> endedSince_;
};

using EncodedFeedPtr = std::shared_ptr<EncodedFeed>;

} // namespace dewpoint::capture
