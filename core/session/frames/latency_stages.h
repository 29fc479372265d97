// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/duration_histogram.h"
#include "core/capture/frame.h"

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace dewpoint::session {

/// Durations in seconds over the run so far; 0 before the first.
struct Latency {
  double median = 0.0;
  double p99 = 0.0;
  double longest = 0.0;
};

/// Returns median, 99th percentile and longest of durations.
Latency latencyOf(const DurationHistogram& durations);

/// Number of values of TimeOrigin.
inline constexpr std::size_t kTimeOrigins = 3;

/// Where the time from light to estimate, and to the screen, goes for live images.
struct LiveLatency {
  Latency capture; ///< exposure and transfer: from the capture time to the arrival of the data
  Latency decode;  ///< from the arrival to the finished image
  Latency wait;    ///< until the tracking thread takes the image, with those of other cameras
  Latency compute; ///< until the estimate
  Latency draw;    ///< from the estimate until it is painted in a camera view
  Latency total;   ///< from the capture time to the estimate
  /// Images by the origin of their capture times, indexed by TimeOrigin. The total of an image
  /// whose time is that of its arrival lacks the part `capture`, to which only the others
  /// contribute.
  std::array<std::int64_t, kTimeOrigins> images{};
};

/// Collects the durations of LiveLatency.
class LatencyStages {
public:
  using Clock = std::chrono::steady_clock;

  /// Adds the images of a frame set that the tracking thread took at `taken` and whose estimate was
  /// there at `estimated`. Images without instants (recordings) are not counted.
  void addFrames(const FrameSet& frames, Clock::time_point taken, Clock::time_point estimated);
  /// Adds the time from an estimate until it was painted, in seconds.
  void addDrawing(double seconds) { draw_.add(seconds); }
  LiveLatency summary() const;

private:
  DurationHistogram capture_;
  DurationHistogram decode_;
  DurationHistogram wait_;
  DurationHistogram compute_;
  DurationHistogram draw_;
  DurationHistogram total_;
  std::array<std::int64_t, kTimeOrigins> images_{};
};

} // namespace dewpoint::session
