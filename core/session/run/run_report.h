// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/duration_histogram.h"
#include "core/project/project.h"
#include "core/tracking/clock_estimate.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dewpoint::session {

/// Statistics of a run so far.
struct RunStatistics {
  std::int64_t frames = 0;
  /// Wall-clock time from the arrival of the first frame to the last estimate.
  double seconds = 0.0;
  std::int64_t droppedFrames = 0;
  int threads = 1;                   ///< number of filter threads
  bool finished = false;             ///< the end of the input was reached
  DurationHistogram iterations;      ///< duration of one filter iteration, per target
  DurationHistogram latency;         ///< time from the arrival of a frame set to its estimate
  std::vector<ClockEstimate> clocks; ///< per camera; empty if the method estimates none
  std::vector<std::string> notices;
};

/// Returns the text of run.json: statistics, method, seed, parameters and corrections of a run.
std::string runReport(const Project& project, const RunStatistics& figures);

} // namespace dewpoint::session
