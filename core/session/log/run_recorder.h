// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/log/run_log.h"
#include "core/session/run/frame_loop.h"
#include "core/session/run/result_settings.h"
#include "core/session/run/tracking_run.h"
#include "core/session/snapshot/snapshot.h"

#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

namespace dewpoint::session {

/// Records the frames of a run in the log, and collects statistics of its speed. Used by the
/// tracking thread only.
class RunRecorder final : public FrameObserver {
public:
  /// Creates a recorder that writes to `log` and computes position errors from the true positions
  /// `truth`. Both must outlive the recorder.
  RunRecorder(RunLog& log, const TruthTable& truth) : log_(log), truth_(truth) {}

  /// Notes that the run restarts from scratch.
  void restart();
  /// Notes that the run has gone back and tracks again from this frame on.
  void goBack(std::int64_t frame) { settings_.goBack(frame); }
  /// Restarts the measurement of the frame rate after an interruption.
  void noteInterruption() { frameTimes_.clear(); }
  /// Notes the time at which work on a frame begins (the frame is about to be taken), for the
  /// statistics of the time per frame.
  void noteWorkBegin() { begun_ = Clock::now(); }
  /// Notes that a frame was taken. `isLive` is true if the frame has just come from live cameras.
  void noteFrameTaken(bool isLive);
  /// Sets the current problems of the live cameras, which are recorded with each frame from now on.
  void setCameraProblems(std::vector<Error> problems);
  /// Sets the arrival time of the next tracked frame to now, so that the time for which the run was
  /// paused does not count as latency.
  void resetArrivalTime();

  void onIteration(const TrackingRun& run, double microseconds) override;
  Status onFrameTracked(const TrackingRun& run) override;
  /// Records the estimates of the current frame, replacing earlier ones of the same frame.
  void record(const TrackingRun& run, const TrackedFrame& trackedFrame);

  /// Adds frame rate, time per iteration, latency and time budget to a snapshot.
  void addStatistics(TrackSnapshot& snapshot) const;
  /// Stores in the log which results came from settings other than `now`.
  void updateOldResults(const RunDefinition& now) const;

private:
  using Clock = std::chrono::steady_clock;

  std::vector<IterationRecord> records(const TrackingRun& run) const;
  /// Counts an iteration that took this many milliseconds in the statistics of the current time
  /// budget.
  void countAgainstBudget(const ParameterValues& parameters, double milliseconds);

  RunLog& log_;
  const TruthTable& truth_;
  Clock::time_point arrival_;                     ///< arrival of the current frame
  Clock::time_point estimated_{};                 ///< end of the newest frame
  std::optional<Clock::time_point> firstArrival_; ///< first arrival since the last start or restart
  bool isLive_ = false;  ///< the current frame is live, and has not been tracked before
  bool isFresh_ = false; ///< the current frame is live, and its tracking began at its arrival
  std::deque<Clock::time_point> frameTimes_;
  std::deque<double> iterationTimes_; ///< microseconds
  BudgetStatistics budget_;
  ResultSettings settings_;
  std::shared_ptr<const std::vector<Error>> cameraProblems_; ///< null: none
  std::optional<Clock::time_point> begun_; ///< start of the work on the current frame
  std::deque<double> workTimes_;           ///< work per frame, seconds
};

} // namespace dewpoint::session
