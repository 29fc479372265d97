// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/frame_loop.h"
#include "core/session/run/result_settings.h"
#include "core/session/run/snapshot.h"
#include "core/session/run/tracking_run.h"
#include "core/session/run_log.h"

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace dewpoint::session {

/// Writes into the log what becomes of a run's frames, and keeps the figures of speed. Used by the
/// tracking thread only.
class RunRecorder final : public FrameObserver {
public:
  /// Both must outlive it. `truth` is what errors are measured against.
  RunRecorder(RunLog& log, const TruthTable& truth) : log_(log), truth_(truth) {}

  /// The run begins again.
  void restart();
  /// It tracks again from this frame on.
  void goBack(std::int64_t frame) { settings_.goBack(frame); }
  /// Frames will not come as evenly as they did: their rate is measured again.
  void interrupt() { frameTimes_.clear(); }
  /// A frame is about to be taken.
  void await() { awaited_ = Clock::now(); }
  /// A frame was taken.
  void arrive();
  /// The frame that is tracked next has waited: what a paused run waits for is not its delay.
  void arriveNow();

  void iterated(const TrackingRun& run, double microseconds) override;
  Status tracked(const TrackingRun& run) override;
  /// The estimates of the run's frame, in place of earlier ones of the same frame.
  void record(const TrackingRun& run, const TrackedFrame& trackedFrame);

  /// Frame rate, time of an iteration, latency and time budget.
  void addFigures(TrackSnapshot& snapshot) const;
  /// Tells the log which results are not of the settings of now.
  void compare(const RunDefinition& now) const;

private:
  using Clock = std::chrono::steady_clock;

  std::vector<IterationRecord> records(const TrackingRun& run) const;
  /// Counts an iteration that took so long, in milliseconds, against the budget of now.
  void countAgainstBudget(const ParameterValues& parameters, double milliseconds);

  RunLog& log_;
  const TruthTable& truth_;
  Clock::time_point arrival_;                     ///< of the run's frame
  std::optional<Clock::time_point> firstArrival_; ///< since the (re)start
  std::deque<Clock::time_point> frameTimes_;
  std::deque<double> iterationTimes_; ///< microseconds
  BudgetFigures budget_;
  ResultSettings settings_;
  std::optional<Clock::time_point> awaited_; ///< since when the run's frame takes time
  std::deque<double> workTimes_;             ///< of frames, seconds
};

} // namespace dewpoint::session
