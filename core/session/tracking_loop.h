// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/command_queue.h"
#include "core/session/run_log.h"
#include "core/session/session.h"
#include "core/session/tracking_run.h"

#include <chrono>
#include <deque>

namespace dewpoint {

/// What the tracking thread does: obey commands, take frame sets, iterate, publish.
class TrackingLoop {
public:
  explicit TrackingLoop(SessionInputs inputs);
  void run(const std::stop_token& stop);

  CommandQueue& commands() { return commands_; }
  SnapshotPublisher& publisher() { return publisher_; }
  const SnapshotPublisher& publisher() const { return publisher_; }
  const RunLog& log() const { return log_; }

private:
  using Clock = std::chrono::steady_clock;

  void obey(const Command& command);
  void changeMethod(const command::SetMethod& wish);
  void changeTargets(const std::vector<Target>& targets);
  /// False if there is nothing to track.
  bool restart(std::optional<std::uint64_t> seed);
  /// Takes the next frame set; false at the end, on an error, or when nothing came (live).
  bool takeFrame();
  void iterateFrame();
  bool iterateOnce();
  /// The estimates of the frame shown, in place of earlier ones of the same frame.
  void recordFrame();
  void publish();
  std::vector<cv::Mat> masks() const;

  Project project_;
  std::unique_ptr<FrameSetSource> source_;
  TruthTable truth_;
  std::shared_ptr<const CameraRig> rig_;
  std::optional<TrackingRun> run_;
  CommandQueue commands_;
  SnapshotPublisher publisher_;
  RunLog log_;

  PlayState state_ = PlayState::Paused;
  bool masksWanted_ = false;
  bool frameFresh_ = false; ///< taken, but without any iteration yet
  std::optional<std::int64_t> recordedFrame_;
  Clock::time_point arrival_;                     ///< of the frame shown
  std::optional<Clock::time_point> firstArrival_; ///< since the (re)start
  std::vector<Error> errors_;
  std::vector<std::deque<Eigen::Vector3d>> tails_;
  std::deque<double> iterationTimes_;
  std::deque<Clock::time_point> frameTimes_;
  Clock::time_point nextFrameDue_ = Clock::now();
};

} // namespace dewpoint
