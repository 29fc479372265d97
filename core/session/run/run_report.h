// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/duration_histogram.h"
#include "core/base/error.h"
#include "core/project/project.h"
#include "core/session/frames/latency_stages.h"
#include "core/tracking/clock_estimate.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::session {

/// Notice (warning for the user) of a run, and the period for which the cause of the notice lasted.
struct NoticePeriod {
  std::string text;
  double startSeconds = 0.0; ///< time when the cause was first noticed, in seconds of the run
  /// Time when the cause was over, in seconds of the run; empty while it lasts.
  std::optional<double> endSeconds;
};

/// Records which notices a run had, and when. If a cause comes back, another period is added.
class NoticeLog {
public:
  /// Maximum number of periods; later ones are not recorded.
  static constexpr std::size_t kMaxPeriods = 1000;

  /// Sets all notices that the run has at `time`, in seconds of the run. Times must not decrease.
  void update(const std::vector<Error>& notices, double time);
  /// Returns the periods of all notices, ordered by their start.
  const std::vector<NoticePeriod>& periods() const { return periods_; }

private:
  std::vector<NoticePeriod> periods_;
};

/// Statistics of a run so far.
struct RunStatistics {
  std::int64_t frameCount = 0;
  /// Wall-clock time from the arrival of the first frame to the last estimate.
  double durationSeconds = 0.0;
  std::int64_t droppedFrameCount = 0;
  int threadCount = 1;                  ///< number of threads that run the particle filters
  bool isFinished = false;              ///< true if the end of the input was reached
  DurationHistogram iterationDurations; ///< duration of one filter iteration, per target
  /// Latency of live images, from the capture to the display, divided into stages.
  LatencyStages liveLatency;
  DurationHistogram frameDurations; ///< time from the arrival of a frame set to its estimate
  /// Clock error of each camera; empty if the method estimates none.
  std::vector<ClockEstimate> clockEstimates;
  std::vector<std::string>
      notices; ///< every notice so far, once, including those whose cause is over
  /// Periods in which the notices applied; notices about moved cameras are left out.
  NoticeLog noticeLog;
};

/// Returns the text of run.json: statistics, method, seed, parameters and corrections of a run.
std::string runReport(const Project& project, const RunStatistics& statistics);

} // namespace dewpoint::session
