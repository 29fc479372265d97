// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/frame_loop.h"

#include <chrono>

namespace dewpoint::session {

/// Measures the time that a run spends in its tracker. The time for reading frames and the time
/// spent in other observers are not included.
class TrackingClock final : public FrameObserver {
public:
  void onFrameTaken(const FrameSet& /*frames*/) override { since_ = Clock::now(); }
  void onIteration(const TrackingRun& /*run*/, double /*microseconds*/) override {
    const Clock::time_point now = Clock::now();
    seconds_ += std::chrono::duration<double>(now - since_).count();
    since_ = now;
  }

  double seconds() const { return seconds_; }

private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point since_;
  double seconds_ = 0.0;
};

} // namespace dewpoint::session
