// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/duration_histogram.h"
#include "core/capture/frame.h"

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace dewpoint::session {

/// Median, 99th percentile and maximum of a latency over the run so far, in seconds; 0 before the
/// first measurement.
struct Latency {
  double median = 0.0;
  double p99 = 0.0;
  double longest = 0.0;
};

/// Returns the median, the 99th percentile and the maximum of the durations, in seconds.
Latency latencyOf(const DurationHistogram& durations);

/// Number of values of TimeOrigin, which says where the capture time of an image comes from.
inline constexpr std::size_t kTimeOriginCount = 3;

/// Latency of live images, from the capture to the estimate and to the display, divided into
/// stages.
struct LiveLatency {
  Latency capture; ///< exposure and transfer: from the capture time to the arrival of the data
  Latency decode;  ///< from the arrival to the decoded image
  Latency wait;    ///< from the decoded image until the tracking thread takes it
  Latency compute; ///< from when the tracking thread takes the images to the estimate
  Latency draw;    ///< from the estimate until a camera view has painted it
  Latency total;   ///< from the capture time to the estimate
  /// Number of images for each origin of the capture time, indexed by TimeOrigin. An image whose
  /// capture time is unknown counts under TimeOrigin::Arrival. Such images do not contribute to
  /// `capture`, and their share of `total` is measured from the arrival.
  std::array<std::int64_t, kTimeOriginCount> imageCounts{};
};

/// Collects the durations from which LiveLatency, the latency of live images, is computed.
class LatencyStages {
public:
  using Clock = std::chrono::steady_clock;

  /// Adds the images of a frame set. `taken` is when the tracking thread took the set, `estimated`
  /// when its estimate was finished. Images from recordings are not counted.
  void addFrames(const FrameSet& frames, Clock::time_point taken, Clock::time_point estimated);
  /// Adds the time from an estimate until a view has painted it, in seconds.
  void addDrawingTime(double seconds) { draw_.add(seconds); }
  LiveLatency summary() const;

private:
  DurationHistogram capture_;
  DurationHistogram decode_;
  DurationHistogram wait_;
  DurationHistogram compute_;
  DurationHistogram draw_;
  DurationHistogram total_;
  std::array<std::int64_t, kTimeOriginCount> images_{};
};

} // namespace dewpoint::session
