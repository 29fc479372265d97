// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <algorithm>
#include <chrono>

namespace dewpoint::broadcast {

/// Decides which frames are sent, so that at most `rate` frames per second are sent on average.
class RateLimit {
public:
  using Clock = std::chrono::steady_clock;

  /// `rate`: maximum number of frames per second; 0: no limit.
  explicit RateLimit(double rate)
      : period_(rate > 0.0 ? std::chrono::duration_cast<Clock::duration>(
                                 std::chrono::duration<double>(1.0 / rate))
                           : Clock::duration::zero()) {}

  /// Returns whether to send a frame that arrives at `now`. A frame may arrive early by up to a
  /// third of the interval between frames. Cameras with exactly the maximum rate therefore lose no
  /// frames, although their frames do not arrive at regular intervals. On average, the maximum rate
  /// is still not exceeded.
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
