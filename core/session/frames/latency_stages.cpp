// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/frames/latency_stages.h"

#include <algorithm>
#include <numeric>

namespace dewpoint::session {
namespace {

/// Two clocks of one image may contradict each other by a little.
double secondsBetween(LatencyStages::Clock::time_point begin,
                      LatencyStages::Clock::time_point end) {
  return std::max(0.0, std::chrono::duration<double>(end - begin).count());
}

} // namespace

Latency latencyOf(const DurationHistogram& durations) {
  constexpr double kMedian = 0.5;
  constexpr double kNearlyAll = 0.99;
  return {durations.quantile(kMedian), durations.quantile(kNearlyAll), durations.longest()};
}

void LatencyStages::addFrames(const FrameSet& frames, Clock::time_point taken,
                              Clock::time_point estimated) {
  bool isLive = false;
  for (const FramePtr& frame : frames.frames) {
    if (!frame || frame->instants.decodedAt == Clock::time_point{}) {
      continue;
    }
    isLive = true;
    const LiveInstants& passed = frame->instants;
    const bool isKnown = frame->origin != TimeOrigin::Arrival;
    if (isKnown) {
      capture_.add(secondsBetween(passed.capturedAt, passed.arrivedAt));
    }
    decode_.add(secondsBetween(passed.arrivedAt, passed.decodedAt));
    wait_.add(secondsBetween(passed.decodedAt, taken));
    total_.add(secondsBetween(isKnown ? passed.capturedAt : passed.arrivedAt, estimated));
    ++images_[static_cast<std::size_t>(frame->origin)];
  }
  if (isLive) {
    compute_.add(secondsBetween(taken, estimated));
  }
}

LiveLatency LatencyStages::summary() const {
  LiveLatency summary;
  summary.imageCounts = images_;
  if (std::accumulate(images_.begin(), images_.end(), std::int64_t{0}) > 0) {
    summary.capture = latencyOf(capture_);
    summary.decode = latencyOf(decode_);
    summary.wait = latencyOf(wait_);
    summary.compute = latencyOf(compute_);
    summary.draw = latencyOf(draw_);
    summary.total = latencyOf(total_);
  }
  return summary;
}

} // namespace dewpoint::session
