// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/command.h"
#include "core/session/frames/frame_tap.h"
#include "core/session/playback.h"
#include "core/session/remembered_run.h"
#include "core/session/run/camera_agreement_watch.h"
#include "core/session/run/camera_motion_observer.h"
#include "core/session/run/run_definition.h"
#include "core/session/run/tracking_run.h"
#include "core/session/run_log.h"
#include "core/session/run_recorder.h"
#include "core/session/session_inputs.h"
#include "core/session/snapshot_builder.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace dewpoint::session {

/// Drives a run over the frames of its input: forward, back to a frame of the past, and on from
/// there with what has changed. Used by the tracking thread only.
class RunDriver {
public:
  /// `tap`, `log` and `truth` must outlive it.
  RunDriver(SessionInputs inputs, FrameTapSlot& tap, RunLog& log, const TruthTable& truth);
  RunDriver(const RunDriver&) = delete;
  RunDriver& operator=(const RunDriver&) = delete;

  /// Whether there is something to track, and something to track it with.
  bool isReady() const { return kept_.exists() && source_; }
  /// Takes the first frame; it is shown, but not yet tracked.
  void start();
  const Playback& playback() const { return playback_; }
  /// Of the input; there is one.
  double framesPerSecond() const { return source_->framesPerSecond(); }
  bool isLive() const { return source_->isLive(); }
  /// Of the run.
  std::int64_t iterations() const { return run().iterations(); }
  /// Whether every target is held; also where there is none.
  bool isHeld() const { return std::ranges::all_of(run().estimates(), tracking::isHeld); }

  // Playing.
  void play();
  void pause() { playback_.pause(); }
  /// Shows the next frame, after tracking it if need be, and waits.
  void stepFrame();
  /// One iteration on the head's frame.
  void stepIteration();
  /// False if there is nothing to track.
  bool restart(std::optional<std::uint64_t> seed);
  /// What goes on by itself goes on: tracks a frame, or only the next iteration of it, or shows the
  /// next frame of the past.
  void advance(bool oneIteration = false);

  // Going back.
  void show(std::int64_t frame) { playback_.show(travel().nearest(frame), head()); }
  void returnToHead() { playback_.returnToHead(); }
  /// Tracks again from this frame on; with `thenView`, the frame that is shown now is shown again
  /// afterwards.
  void rerun(std::int64_t from, bool thenView = false) { rerun(from, nullptr, thenView); }

  // Changes. What is believed stays as far as it can.
  /// A definition that the run takes(); false if it does not.
  bool change(RunDefinition wanted);
  void setMethod(const command::SetMethod& request);
  void setTargets(const std::vector<Target>& targets);
  void setCameras(const CameraRig& rig);
  void setEmptyRooms(const command::SetEmptyRooms& request);
  /// While a board is shown to live cameras none of them is taken for moved.
  void setBoardShown(bool shown) {
    motionWatch_.setResting(shown);
    agreementWatch_.setResting(shown);
  }
  void setPeople(const std::vector<PersonCorrection>& people);
  void setCorrections(const std::vector<PositionCorrection>& corrections);
  /// As SessionInputs::threads, from the next iteration on.
  void setThreads(int wanted);

  /// What is tracked from now on.
  const RunDefinition& definition() const { return *kept_.definition(); }
  /// Fills in everything but what the publishing thread knows itself; `quickly`: a preview will do
  /// if the images would take long.
  void describe(const SnapshotBuilder& builder, bool quickly, TrackSnapshot& snapshot);
  /// Adds to a snapshot of the past what only tracking up to its frame can tell, unless `goOn` says
  /// no.
  void addMaps(const SnapshotBuilder& builder, TrackSnapshot& snapshot,
               const TimeTravel::GoOn& goOn);

private:
  /// The frame the run stands at; -1 before the first.
  std::int64_t head() const { return kept_.head(); }
  TrackingRun& run() { return kept_.run(); }
  const TrackingRun& run() const { return kept_.run(); }
  TimeTravel& travel() { return kept_.travel(); }
  const TimeTravel& travel() const { return kept_.travel(); }
  /// Goes on with a run of its own for another definition, which knows nothing yet. False if that
  /// cannot be made; then all stays as it was.
  bool replaceRun(RunDefinition definition, std::int64_t iterations);
  /// The project with the definition of now.
  Project project() const { return definition().appliedTo(project_); }

  Result<FrameSetPtr> nextFrames();
  /// Takes the next frame set; false at the end, on an error, or when nothing came (live).
  bool takeFrame();
  void iterateFrame(FrameStep step = FrameStep::WholeFrame);
  void showNext();
  void record() {
    recorder_.record(run(), kept_.record());
    playback_.record();
  }

  void rerun(std::int64_t from, const command::SetMethod* method, bool thenView);
  /// Where tracking by another method begins so that it can be tracked at `from`.
  std::int64_t beginOf(const command::SetMethod& method, std::int64_t from) const;
  void changeBoxes(RunDefinition wanted);
  /// Goes by other corrections, which the method can apply if `canApply`. Tracks again from the
  /// first frame for which they are otherwise; but when they are only added and begin at the head,
  /// returns those of the head, to be applied to it.
  template <class Correction>
  std::vector<Correction> takeCorrections(std::vector<Correction> RunDefinition::*member,
                                          const std::vector<Correction>& wanted, bool canApply);
  void note(const Error& error) { errors_.push_back(error); }
  void showFrame(const SnapshotBuilder& builder, bool quickly, TrackSnapshot& snapshot);

  Project project_; ///< as it was opened; definition() goes before it
  std::unique_ptr<FrameSetSource> source_;
  FrameTapSlot& tap_;
  RunLog& log_;
  RememberedRun kept_;            ///< no run if the project's could not be made
  CameraMotionWatch motionWatch_; ///< of the cameras as they were calibrated
  CameraMotionObserver motionObserver_{motionWatch_};
  CameraAgreementWatch agreementWatch_; ///< of the cameras as the project has them
  RunRecorder recorder_;
  std::array<FrameObserver*, 3> observers_{&motionObserver_, &agreementWatch_, &recorder_};
  Playback playback_;
  std::vector<Error> errors_;
};

} // namespace dewpoint::session
