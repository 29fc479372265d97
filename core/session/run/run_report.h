// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/duration_histogram.h"
#include "core/project/project.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dewpoint::session {

/// How a run went so far.
struct RunFigures {
  std::int64_t frames = 0;
  double seconds = 0.0; ///< wall clock, from the first frame's arrival to the last estimate
  std::int64_t droppedFrames = 0;
  int threads = 1;              ///< of the filter
  bool finished = false;        ///< the input's end was reached
  DurationHistogram iterations; ///< time of one filter iteration, per target
  DurationHistogram latency;    ///< from the arrival of a frame set to its estimate
  std::vector<std::string> notices;
};

/// The text of run.json: figures, method, seed, parameters and corrections of a run.
std::string runReport(const Project& project, const RunFigures& figures);

} // namespace dewpoint::session
