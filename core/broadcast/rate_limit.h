// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <algorithm>
#include <chrono>

namespace dewpoint::broadcast {

/// Decides which frames are sent, so that there are at most `rate` per second.
class RateLimit {
public:
  using Clock = std::chrono::steady_clock;

  /// A rate of 0 lets all frames pass.
  explicit RateLimit(double rate)
      : period_(rate > 0.0 ? std::chrono::duration_cast<Clock::duration>(
                                 std::chrono::duration<double>(1.0 / rate))
                           : Clock::duration::zero()) {}

  /// Returns whether a frame that arrives now is sent. A frame may be early by a third of the
  /// period: frames of cameras at this rate, which do not arrive evenly, then all pass. Over time,
  /// the rate is still kept.
  bool isDue(Clock::time_point now) {
    if (now + period_ / 3 < due_) {
      return false;
    }
    due_ = std::max(due_ + period_, now);
    return true;
  }

private:
  Clock::duration period_;
  Clock::time_point due_{};
};

} // namespace dewpoint::broadcast
