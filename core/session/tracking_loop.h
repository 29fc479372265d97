// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/command_queue.h"
#include "core/session/frames/frame_tap.h"
#include "core/session/log/run_log.h"
#include "core/session/playback_pace.h"
#include "core/session/run_driver.h"
#include "core/session/snapshot_builder.h"
#include "core/session/snapshot_publisher.h"

#include <chrono>
#include <stop_token>

namespace dewpoint::session {

/// Main loop of the tracking thread: executes commands, advances the run on schedule, and publishes
/// snapshots.
class TrackingLoop {
public:
  explicit TrackingLoop(SessionInputs inputs);
  void run(const std::stop_token& stop);

  CommandQueue& commands() { return commands_; }
  FrameTapSlot& frameTap() { return tap_; }
  SnapshotPublisher& publisher() { return publisher_; }
  const SnapshotPublisher& publisher() const { return publisher_; }
  const RunLog& log() const { return log_; }
  /// Adds the time, in seconds, from a live estimate until a view has painted it. May be called by
  /// any thread.
  void addDrawingTime(double seconds) { log_.addDrawingTime(seconds); }

private:
  using Clock = std::chrono::steady_clock;

  /// When to publish a snapshot after a command.
  enum class Publish {
    Now,
    Quickly,   ///< immediately; the images may be previews
    Throttled, ///< at most as often as the screen is refreshed
    Not        ///< nothing has changed
  };
  /// Executes a command by calling the handle() for its type.
  void execute(const Command& command);
  Publish handle(const command::Play& request);
  Publish handle(const command::Pause& request);
  Publish handle(const command::StepFrame& request);
  Publish handle(const command::StepIteration& request);
  Publish handle(const command::Restart& request);
  Publish handle(const command::SetParameters& request);
  Publish handle(const command::SetMethod& request);
  Publish handle(const command::SetTargets& request);
  Publish handle(const command::SetCameras& request);
  Publish handle(const command::SetBackgroundImages& request);
  Publish handle(const command::SetPersonCorrections& request);
  Publish handle(const command::SetVolumeOfInterest& request);
  Publish handle(const command::SetCorrections& request);
  Publish handle(const command::SetThreadCount& request);
  Publish handle(const command::SetPace& request);
  Publish handle(const command::ShowMasks& request);
  Publish handle(const command::ShowMaps& request);
  Publish handle(const command::ShowBodyShapes& request);
  Publish handle(const command::ShowCalibrationBoard& request);
  Publish handle(const command::ShowFrame& request);
  Publish handle(const command::ReturnToNewestFrame& request);
  Publish handle(const command::Rerun& request);
  Publish handle(const command::DescribeFrame& request);

  const Playback& playback() const { return driver_.playback(); }
  PlaybackPace::Situation situation() const;
  /// Returns when the next step is due; nothing if the thread waits for a command.
  std::optional<Clock::time_point> deadline() const;
  /// Takes the step that is due and schedules the next one. After a slow step, the schedule is
  /// shifted so that no burst follows; frames are never skipped.
  void takeDueStep();
  /// Schedules the first step after playing has started or its settings have changed.
  void scheduleFirstStep();
  /// Returns how to publish while frames are tracked or replayed. If past frames are tracked again
  /// or the playback is faster than real time, this is Throttled: not every frame is published.
  /// Otherwise it is Now.
  Publish playbackPublish() const;
  void publish(Publish how);
  void addMaps(const std::stop_token& stop);

  CommandQueue commands_;
  FrameTapSlot tap_;
  SnapshotPublisher publisher_;
  RunLog log_;
  SnapshotBuilder builder_;
  RunDriver driver_;
  Clock::time_point published_;
  PlaybackPace pace_;
  Clock::time_point nextStepDue_ = Clock::now();
  /// Nothing is published before this time while past frames are tracked again.
  Clock::time_point viewKeptUntil_;
};

} // namespace dewpoint::session
