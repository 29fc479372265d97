// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/rewind/time_travel.h"
#include "core/session/run/run_definition.h"
#include "core/session/run/tracking_run.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace dewpoint::session {

/// A run, its definition and its history, kept consistent. Every frame that the run begins and
/// every change to it are also recorded in the history. The run can therefore return to any
/// recorded frame and continue from there with bit-identical results. Used by the tracking thread
/// only.
class RunWithHistory {
public:
  /// Creates an object without a run. `threads` is the number of filter threads. There is no run
  /// before replace(), and no history before keepHistory().
  RunWithHistory(RunDefinition definition, int threads);

  /// Starts a new run from scratch with another definition. Its iterations are counted from
  /// `iterations`. If the run cannot be created, nothing changes. Recorded results are kept.
  Status replace(RunDefinition definition, std::int64_t iterations);
  /// Starts recording the run's history over the frames of `source`, using at most `bytes` of
  /// memory; 0 stands for the default limit.
  void keepHistory(FrameSetSource& source, std::size_t bytes);

  bool exists() const { return run_.has_value(); }
  TrackingRun& run() { return *run_; }
  const TrackingRun& run() const { return *run_; }
  TimeTravel& timeTravel() { return *travel_; }
  const TimeTravel& timeTravel() const { return *travel_; }
  /// Returns null before keepHistory().
  const History* history() const { return travel_ ? &travel_->history() : nullptr; }
  /// Returns the definition for new frames; never null. The run uses a different definition only
  /// while it is being brought back to a past frame.
  const RunDefinitionPtr& definition() const { return definition_; }
  int threads() const { return threads_; }
  /// Returns the frame that the run is at; -1 before the first.
  std::int64_t head() const { return run_ && run_->frames() ? run_->frames()->index : -1; }

  /// Begins a frame.
  void begin(const FrameSetPtr& frames);
  /// Records the current frame in the history.
  const TrackedFrame& record() { return travel_->record(*run_); }
  /// Applies another definition from the next iteration on; tracks continue as far as possible.
  /// Returns false if the run does not accept it and a new run is needed.
  bool change(RunDefinition wanted);
  /// Applies a correction for people or of a position in the current frame.
  void change(const RunChange& runChange);
  /// Restores the state of the run right before it began a frame. There is one exception: if a
  /// recording is tracked again from before the first iteration of the run, a new run with the
  /// current definition is created. Tracking a recording again from its beginning therefore gives
  /// the same result as opening it again. Recorded results are kept.
  Status goBack(std::int64_t frame, bool isLive);
  /// After goBack(), applies the changes that were made later than the restored state. They take
  /// effect in the frame that is begun next.
  void applyLaterChanges();
  void setThreads(int threads);
  /// Discards all tracks and the whole history. If `seed` is empty, the previous seed is used.
  void restart(std::optional<std::uint64_t> seed);

private:
  int threads_;
  RunDefinitionPtr definition_;
  std::optional<TrackingRun> run_;
  std::optional<TimeTravel> travel_;
};

} // namespace dewpoint::session
