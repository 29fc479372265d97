// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/rewind/time_travel.h"
#include "core/session/run/run_definition.h"
#include "core/session/run/tracking_run.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace dewpoint::session {

/// A run, what it goes by, and what is remembered of it, kept in step: every frame that the run
/// begins and every change that it is told are in its history too, so that it can go back to any
/// frame and on from there with the same bits. Used by the tracking thread only.
class RememberedRun {
public:
  /// `threads` share the work of the filter. There is no run before replace(), and no history
  /// before keepHistory().
  RememberedRun(RunDefinition definition, int threads);

  /// Another run, of another definition, which knows nothing yet; it has made `iterations`.
  /// If it cannot be made, all stays as it was. What was recorded stays.
  Status replace(RunDefinition definition, std::int64_t iterations);
  /// Remembers from now on what the run does over the frames of `source`, within `bytes`; 0: the
  /// usual limit.
  void keepHistory(FrameSetSource& source, std::size_t bytes);

  bool exists() const { return run_.has_value(); }
  TrackingRun& run() { return *run_; }
  const TrackingRun& run() const { return *run_; }
  TimeTravel& travel() { return *travel_; }
  const TimeTravel& travel() const { return *travel_; }
  /// Null before keepHistory().
  const History* history() const { return travel_ ? &travel_->history() : nullptr; }
  /// What is tracked from now on; never null. The run goes by another one only while it is brought
  /// back to a frame of the past.
  const RunDefinitionPtr& definition() const { return definition_; }
  int threads() const { return threads_; }
  /// The frame the run stands at; -1 before the first.
  std::int64_t head() const { return run_ && run_->frames() ? run_->frames()->index : -1; }

  void begin(const FrameSetPtr& frames);
  const TrackedFrame& record() { return travel_->record(*run_); }
  /// Another definition, from the next iteration on; what is believed stays as far as it can. False
  /// if the run does not take it: it needs a run of its own.
  bool change(RunDefinition wanted);
  /// A correction in the frame the run stands at, of its people or of a position.
  void change(const RunChange& said);
  /// Makes the run what it was right before it began a frame. Where it knew nothing yet, it is a
  /// new one, of the definition of now: so tracking a recording again from its beginning gives what
  /// a run that has just been opened gives. Nothing is forgotten of what was recorded.
  Status goBack(std::int64_t frame, bool isLive);
  /// After going back: what has changed since then holds from the frame begun now.
  void catchUp();
  void setThreads(int threads);
  /// Forgets all beliefs and all that was remembered.
  void restart(std::optional<std::uint64_t> seed);

private:
  int threads_;
  RunDefinitionPtr definition_;
  std::optional<TrackingRun> run_;
  std::optional<TimeTravel> travel_;
};

} // namespace dewpoint::session
