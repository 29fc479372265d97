// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/command_queue.h"
#include "core/session/frames/frame_tap.h"
#include "core/session/history/time_travel.h"
#include "core/session/run/camera_motion_watch.h"
#include "core/session/run/tracking_run.h"
#include "core/session/run_log.h"
#include "core/session/session.h"

#include <chrono>
#include <deque>

namespace dewpoint::session {

/// What the tracking thread does: obey commands, take frame sets, iterate, publish.
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

  /// What a command leaves to be published once it is carried out.
  enum class Publish {
    Now,
    Quickly, ///< a preview will do
    Done,    ///< nothing: the command has published by itself
  };
  /// Carries out a command. A type of command without a handle() of its own does not compile.
  void obey(const Command& command);
  Publish handle(const command::Play& wish);
  Publish handle(const command::Pause& wish);
  Publish handle(const command::StepFrame& wish);
  Publish handle(const command::StepIteration& wish);
  Publish handle(const command::Restart& wish);
  Publish handle(const command::Configure& wish);
  Publish handle(const command::SetMethod& wish);
  Publish handle(const command::SetTargets& wish);
  Publish handle(const command::SetCameras& wish);
  Publish handle(const command::SetEmptyRooms& wish);
  Publish handle(const command::ChangePeople& wish);
  Publish handle(const command::ShowMasks& wish);
  Publish handle(const command::ShowMaps& wish);
  Publish handle(const command::ShowShapes& wish);
  Publish handle(const command::ShowFrame& wish);
  Publish handle(const command::BackToHead& wish);
  Publish handle(const command::Rerun& wish);
  void changeMethod(const command::SetMethod& wish);
  void changeTargets(const std::vector<Target>& targets);
  void changeBoxes(const std::vector<Target>& targets);
  void changeCameras(const CameraRig& rig);
  void changeEmptyRooms(const command::SetEmptyRooms& wish);
  /// Somebody stands somewhere, or is not there after all; at an earlier moment, the run goes on
  /// from there.
  void changePeople(const command::ChangePeople& wish);
  /// False if there is nothing to track.
  bool restart(std::optional<std::uint64_t> seed);

  // Tracking.
  /// Takes the next frame set; false at the end, on an error, or when nothing came (live).
  bool takeFrame();
  Result<FrameSetPtr> nextFrames();
  void iterateFrame();
  bool iterateOnce();
  std::vector<IterationRecord> iterationRecords() const;
  /// The estimates of the frame shown, in place of earlier ones of the same frame.
  void recordFrame();
  /// Counts an iteration that took so long, in milliseconds, against the budget of now.
  void countAgainstBudget(double milliseconds);
  void reachEnd();

  // Going back.
  /// The frame the run stands at; -1 before the first.
  std::int64_t head() const { return run_ && run_->frames() ? run_->frames()->index : -1; }
  void show(std::int64_t frame);
  void backToHead();
  /// Shows the next moment that was recorded; at the head, the run goes on.
  void showNext();
  void rerun(std::int64_t from, const command::SetMethod* method = nullptr);
  bool goBackTo(std::int64_t from, const command::SetMethod* method);
  std::int64_t beginOf(const command::SetMethod& method, std::int64_t from) const;
  void finishRerun();
  /// What is otherwise than in `before`, for the header of the trajectory.
  std::string differences(const Project& before) const;

  // Publishing.
  /// `quickly`: a preview will do if the images would take long.
  void publish(bool quickly = false);
  /// Less often than a screen shows while tracking as fast as it goes.
  void publishNowAndThen();
  void showHead(TrackSnapshot& snapshot);
  /// Targets of the run that are not in the moment shown.
  void addOthers(TrackSnapshot& snapshot) const;
  /// With methods of family Boxes: of a moment the targets that there are now, in their order.
  void showPresentBoxes(TrackSnapshot& snapshot) const;
  static void addShapes(TrackSnapshot& snapshot);
  void addFigures(TrackSnapshot& snapshot) const;
  static std::vector<cv::Mat> masks(const TrackSnapshot& snapshot);
  void addMaps(const std::stop_token& stop);

  Project project_;
  std::unique_ptr<FrameSetSource> source_;
  TruthTable truth_;
  std::vector<cv::Mat> emptyRooms_;
  std::shared_ptr<const CameraRig> rig_;
  std::optional<TrackingRun> run_;
  CameraMotionWatch bumps_;          ///< of the cameras as they were calibrated
  std::optional<TimeTravel> travel_; ///< as long as there is a source
  CommandQueue commands_;
  FrameTapSlot tap_;
  SnapshotPublisher publisher_;
  RunLog log_;

  PlayState state_ = PlayState::Paused;
  bool masksWanted_ = false;
  bool mapsWanted_ = false;
  bool shapesWanted_ = false;
  bool exactDue_ = false;            ///< a preview is shown
  bool mapsDue_ = false;             ///< the moment shown has no likelihood maps yet
  bool atEnd_ = false;               ///< the input's end was reached
  std::int64_t next_ = 0;            ///< the frame to track next
  std::optional<std::int64_t> view_; ///< the moment shown, if it is not the head's
  struct Rerun {
    RerunState range;
    PlayState afterwards = PlayState::Paused;
    bool atEnd = false;                    ///< the end had been reached
    std::optional<std::int64_t> lookingAt; ///< a moment to show again when it is done
  };
  std::optional<Rerun> rerun_;
  Clock::time_point published_;
  bool frameFresh_ = false; ///< taken, but without any iteration yet
  std::optional<std::int64_t> recordedFrame_;
  Clock::time_point arrival_;                     ///< of the frame shown
  std::optional<Clock::time_point> firstArrival_; ///< since the (re)start
  std::vector<Error> errors_;
  std::vector<std::deque<Eigen::Vector3d>> tails_;
  std::deque<double> iterationTimes_;
  std::deque<Clock::time_point> frameTimes_;
  BudgetFigures budget_;
  Clock::time_point nextFrameDue_ = Clock::now();
};

} // namespace dewpoint::session
