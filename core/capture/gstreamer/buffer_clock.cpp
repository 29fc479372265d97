// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/gstreamer/buffer_clock.h"

#include <algorithm>

namespace dewpoint::capture {

using namespace std::chrono_literals;

namespace {

// Judgments.
constexpr auto kLongestLatency = 5s; ///< from the capture of an image to its arrival
constexpr auto kFutureTolerance = 20ms;
/// Between two images that would have the same time. Tables of capture times have microseconds.
constexpr auto kShortestInterval = 1us;

} // namespace

CaptureInstant BufferClock::later(Clock::time_point time, TimeOrigin origin) {
  last_ = last_ ? std::max<Clock::time_point>(time, *last_ + kShortestInterval) : time;
  return {*last_, origin};
}

CaptureInstant BufferClock::nextCaptureInstant(std::optional<Clock::time_point> stamp,
                                               Clock::time_point arrival) {
  const bool isGood = stamp && *stamp <= arrival + kFutureTolerance &&
                      *stamp >= arrival - kLongestLatency && (!lastStamp_ || *stamp > *lastStamp_);
  if (!isGood) {
    return later(arrival - latency_, TimeOrigin::Arrival);
  }
  lastStamp_ = *stamp;
  const auto time = std::min(*stamp, arrival);
  latency_ = arrival - time;
  return later(time, origin_);
}

} // namespace dewpoint::capture
