// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/rewind/time_travel.h"
#include "core/session/run/run_definition.h"
#include "core/session/run/tracking_run.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace dewpoint::session {

/// A run together with its history, in which every frame of the run and every change to the run are
/// recorded. The run can therefore return to any recorded frame and continue from there with
/// bit-identical results. Used by the tracking thread only.
class RunWithHistory {
public:
  /// Creates an object without a run. `threadCount` is the number of filter threads. startNewRun()
  /// creates the run, and keepHistory() the history.
  RunWithHistory(RunDefinition definition, int threadCount);

  /// Starts a new run from scratch with another definition. Iterations are counted from
  /// `iterations`. Recorded results are kept. Returns an error, and changes nothing, if the run
  /// cannot be created.
  Status startNewRun(RunDefinition definition, std::int64_t iterations);
  /// Starts recording the history of the run, whose frames come from `source`. The history uses at
  /// most `bytes` of memory; 0 means the default limit.
  void keepHistory(FrameSetSource& source, std::size_t bytes);

  bool hasRun() const { return run_.has_value(); }
  TrackingRun& run() { return *run_; }
  const TrackingRun& run() const { return *run_; }
  TimeTravel& timeTravel() { return *travel_; }
  const TimeTravel& timeTravel() const { return *travel_; }
  /// Returns the history of the run; null before keepHistory().
  const History* history() const { return travel_ ? &travel_->history() : nullptr; }
  /// Returns the definition (all settings) with which new frames are tracked; never null.
  const RunDefinitionPtr& definition() const { return definition_; }
  int threadCount() const { return threadCount_; }
  /// Returns the number of the current frame of the run; -1 before the first frame.
  std::int64_t headFrame() const { return run_ && run_->frames() ? run_->frames()->index : -1; }

  /// Begins the next frame of the run with these images, and records the images in the history.
  void beginFrame(const FrameSetPtr& frames);
  /// Records the results of the current frame in the history and returns them.
  const TrackedFrame& record() { return travel_->record(*run_); }
  /// Applies another definition (all settings of the run) from the next iteration on; tracks
  /// continue as far as possible. Returns false if the run cannot continue with this definition, so
  /// that a new run is needed.
  bool change(RunDefinition wanted);
  /// Applies a correction of people, or of a position, in the current frame.
  void change(const RunChange& runChange);
  /// Restores the state that the run had right before it began a frame. Recorded results are kept.
  /// There is one exception: if a recording (`isLive` is false) is tracked again from before the
  /// first iteration of the run, a new run with the current definition is created, so that the
  /// result is the same as after opening the recording again.
  Status goBack(std::int64_t frame, bool isLive);
  /// Applies, after goBack(), the changes that were made to the run after the restored state. They
  /// take effect in the next frame.
  void applyLaterChanges();
  void setThreadCount(int threadCount);
  /// Discards all tracks and the whole history. If `seed` is empty, the previous seed is used.
  void restart(std::optional<std::uint64_t> seed);

private:
  int threadCount_;
  RunDefinitionPtr definition_;
  std::optional<TrackingRun> run_;
  std::optional<TimeTravel> travel_;
};

} // namespace dewpoint::session
