// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_instant.h"

#include <chrono>
#include <optional>

namespace dewpoint::capture {

/// Turns the time stamps of one camera's images into capture times, and replaces those that cannot
/// be true. Capture times increase. For use by one thread only.
///
/// A time stamp is used if it lies between 5 s before and 20 ms after the arrival of its image, and
/// after that of the image before. Otherwise the time of arrival is used, minus the time that the
/// last image with a good stamp took.
class BufferClock {
public:
  using Clock = std::chrono::steady_clock;

  /// `origin`: what good time stamps mean.
  explicit BufferClock(TimeOrigin origin) : origin_(origin) {}

  /// Returns the capture time of the next image. `stamp`: its time stamp by the steady clock, if it
  /// has one. `arrival`: when it arrived.
  CaptureInstant next(std::optional<Clock::time_point> stamp, Clock::time_point arrival);

private:
  CaptureInstant later(Clock::time_point time, TimeOrigin origin);

  TimeOrigin origin_;
  std::optional<Clock::time_point> lastStamp_; ///< the last good one
  std::optional<Clock::time_point> last_;      ///< the last time returned
  Clock::duration latency_{};                  ///< of the last image with a good stamp
};

} // namespace dewpoint::capture
