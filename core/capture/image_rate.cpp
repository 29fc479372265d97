// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/image_rate.h"

#include <utility>

namespace dewpoint::capture {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
/// Weight of the newest interval.
constexpr double kSmoothing = 0.1;
// Judgments: after so long, in seconds and in usual intervals, a camera has paused. One interval of
// a second would make 30 images per second look like 8, and it takes 20 images to get over that.
constexpr double kShortestPause = 0.3;
constexpr double kPauseIntervals = 6.0;

} // namespace

void ImageRate::add(Clock::time_point time) {
  const bool hadLast = std::exchange(hasLast_, true);
  const double interval = std::chrono::duration<double>(time - last_).count();
  if (hadLast && interval <= 0.0) {
    return;
  }
  last_ = time;
  if (!hadLast) {
    return;
  }
  const bool isPause =
      interval_ > 0.0 && interval > kShortestPause && interval > kPauseIntervals * interval_;
  if (isPause && !std::exchange(isPaused_, true)) {
    return;
  }
  isPaused_ = isPause;
  interval_ = interval_ > 0.0 ? (1.0 - kSmoothing) * interval_ + kSmoothing * interval : interval;
}

void ImageRate::restart() {
  hasLast_ = false;
  isPaused_ = false;
}

} // namespace dewpoint::capture
