// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_instant.h"

#include <chrono>
#include <optional>

namespace dewpoint::capture {

/// Computes capture times from the time stamps of one camera's images, and replaces implausible
/// time stamps. Capture times always increase. For use by one thread only.
///
/// A time stamp is plausible if it is between 5 s before and 20 ms after the arrival of its image,
/// and later than the last plausible time stamp. For other images, the capture time is the time of
/// arrival minus the latency of the last image with a plausible time stamp.
class BufferClock {
public:
  using Clock = std::chrono::steady_clock;

  /// `origin`: where the camera's time stamps come from; reported for plausible time stamps only.
  explicit BufferClock(TimeOrigin origin) : origin_(origin) {}

  /// Returns the capture time of the next image. `stamp`: time stamp of the image by the steady
  /// clock, if it has one. `arrival`: time at which the image arrived.
  CaptureInstant nextCaptureInstant(std::optional<Clock::time_point> stamp,
                                    Clock::time_point arrival);

private:
  CaptureInstant later(Clock::time_point time, TimeOrigin origin);

  TimeOrigin origin_;
  std::optional<Clock::time_point> lastStamp_; ///< the last good one
  std::optional<Clock::time_point> last_;      ///< the last time returned
  Clock::duration latency_{};                  ///< of the last image with a good stamp
};

} // namespace dewpoint::capture
