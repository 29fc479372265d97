// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/command_queue.h"
#include "core/session/frames/frame_tap.h"
#include "core/session/playback_pace.h"
#include "core/session/run_driver.h"
#include "core/session/run_log.h"
#include "core/session/snapshot_builder.h"
#include "core/session/snapshot_publisher.h"

#include <chrono>
#include <stop_token>

namespace dewpoint::session {

/// The work of the tracking thread: carries out commands, lets the run go on when it is time, and
/// publishes snapshots.
class TrackingLoop {
public:
  explicit TrackingLoop(SessionInputs inputs);
  void run(const std::stop_token& stop);

  CommandQueue& commands() { return commands_; }
  FrameTapSlot& tap() { return tap_; }
  SnapshotPublisher& publisher() { return publisher_; }
  const SnapshotPublisher& publisher() const { return publisher_; }
  const RunLog& log() const { return log_; }

private:
  using Clock = std::chrono::steady_clock;

  /// What is to be published after a command.
  enum class Publish {
    Now,
    Quickly,   ///< a preview will do
    NowAndThen ///< not more often than a screen shows it
  };
  /// Carries out a command. A type of command without a handle() of its own does not compile.
  void carryOut(const Command& command);
  Publish handle(const command::Play& request);
  Publish handle(const command::Pause& request);
  Publish handle(const command::StepFrame& request);
  Publish handle(const command::StepIteration& request);
  Publish handle(const command::Restart& request);
  Publish handle(const command::Configure& request);
  Publish handle(const command::SetMethod& request);
  Publish handle(const command::SetTargets& request);
  Publish handle(const command::SetCameras& request);
  Publish handle(const command::SetEmptyRooms& request);
  Publish handle(const command::SetPeople& request);
  Publish handle(const command::SetVolumeOfInterest& request);
  Publish handle(const command::SetCorrections& request);
  Publish handle(const command::SetThreads& request);
  Publish handle(const command::SetPace& request);
  Publish handle(const command::ShowMasks& request);
  Publish handle(const command::ShowMaps& request);
  Publish handle(const command::ShowShapes& request);
  Publish handle(const command::ShowBoard& request);
  Publish handle(const command::ShowFrame& request);
  Publish handle(const command::BackToHead& request);
  Publish handle(const command::Rerun& request);

  const Playback& playback() const { return driver_.playback(); }
  PlaybackPace::Situation situation() const;
  /// When the thread has something to do again, unless a command comes; nothing: not by itself.
  std::optional<Clock::time_point> deadline() const;
  /// Does the step that is due, and plans the one after it. A slow step must not be followed by a
  /// burst: the clock is moved on, frames are never skipped.
  void goOn();
  /// Playing begins now, or goes on otherwise.
  void planFirstStep();
  /// As often as is of use: while past frames are tracked again, or frames are played faster than
  /// in real time, less often than every frame.
  Publish usual() const;
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
  Clock::time_point viewKeptUntil_; ///< a rerun shows nothing before
};

} // namespace dewpoint::session
