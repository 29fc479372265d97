// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/command.h"
#include "core/session/frames/frame_tap.h"
#include "core/session/log/run_log.h"
#include "core/session/log/run_recorder.h"
#include "core/session/playback.h"
#include "core/session/run/run_definition.h"
#include "core/session/run/tracking_run.h"
#include "core/session/run_input.h"
#include "core/session/run_with_history.h"
#include "core/session/session_inputs.h"
#include "core/session/snapshot_builder.h"
#include "core/session/watch/camera_watches.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace dewpoint::session {

/// Moves a run through the frames of its input. The run can also go back to a past frame and
/// continue from there with the current settings. Used by the tracking thread only.
class RunDriver {
public:
  /// Creates the run of `inputs`. Frames are passed to `tap` and results written to `log`; position
  /// errors are computed from `truth`. All three must outlive this object.
  RunDriver(SessionInputs inputs, FrameTapSlot& tap, RunLog& log, const TruthTable& truth);
  RunDriver(const RunDriver&) = delete;
  RunDriver& operator=(const RunDriver&) = delete;

  /// Returns whether both a source of frames and a run (which tracks targets in the frames) exist.
  bool isReady() const { return current_.hasRun() && input_.hasSource(); }
  /// Takes the first frame from the source and shows it, without tracking targets in it.
  void start();
  const Playback& playback() const { return playback_; }
  /// Returns the frame rate of the input, which must exist.
  double framesPerSecond() const { return input_.framesPerSecond(); }
  bool isLive() const { return input_.isLive(); }
  /// Returns the number of iterations of the run.
  std::int64_t iterationCount() const { return run().iterationCount(); }
  /// Returns whether every target is held (confirmed by the cameras); true if there are no targets.
  bool isEveryTargetHeld() const {
    return std::ranges::all_of(run().estimates(), tracking::isConfirmed);
  }

  // Playback.
  void play();
  void pause() { playback_.pause(); }
  /// Shows the next frame, after tracking it if necessary, and pauses.
  void stepFrame();
  /// Runs one filter iteration on the current frame of the run, and pauses.
  void stepIteration();
  /// Restarts the run from the first frame, with the previous seed if `seed` is empty. Returns
  /// false if the source has no first frame or cannot go back to it.
  bool restart(std::optional<std::uint64_t> seed);
  /// Takes the next step of the current activity: tracks a frame (with `oneIteration`, only its
  /// next iteration), or shows the next past frame.
  void advance(bool oneIteration = false);

  // Time travel.
  void show(std::int64_t frame) { playback_.show(timeTravel().nearestFrame(frame), headFrame()); }
  void returnToNewestFrame() { playback_.returnToNewestFrame(); }
  /// Starts to track past frames again, from frame `from` on. If `keepView` is true, the frame
  /// shown now is shown again afterward.
  void rerun(std::int64_t from, bool keepView = false) { rerun(from, nullptr, keepView); }

  // Changes. Tracks continue as far as possible.
  /// Applies a definition (all settings of the run). Returns false, and changes nothing, if the run
  /// cannot continue with it, for example because of another method or image size
  /// (TrackingRun::accepts()).
  bool change(RunDefinition wanted);
  void setMethod(const command::SetMethod& request);
  void setTargets(const std::vector<Target>& targets);
  void setCameras(const CameraRig& rig);
  void setBackgroundImages(const command::SetBackgroundImages& request);
  /// Sets whether the user is showing a calibration board to live cameras. Meanwhile, no
  /// camera is reported as moved, because a moving board can look like a camera motion.
  void setCalibrationBoardShown(bool shown) { watches_.setPaused(shown); }
  void setPersonCorrections(const std::vector<PersonCorrection>& people);
  void setCorrections(const std::vector<PositionCorrection>& corrections);
  /// Sets the number of filter threads from the next iteration on; 0 means the default number. The
  /// result does not depend on it.
  void setThreadCount(int wanted);

  /// Returns the definition (all settings) with which new frames are tracked.
  const RunDefinition& definition() const { return *current_.definition(); }
  /// Fills in a snapshot of the frame to show. If `quickly` is true, the images of a past frame may
  /// be previews (small images scaled up) when the full images are not available immediately.
  void fillSnapshot(const SnapshotBuilder& builder, bool quickly, TrackSnapshot& snapshot);
  /// Returns whether the problems of live cameras have changed since the last snapshot; false for
  /// recordings.
  bool haveNoticesChanged() const { return isReady() && isLive() && input_.haveNoticesChanged(); }
  /// Adds likelihood maps or motion masks to a snapshot of a past frame. To compute them, a copy of
  /// the run is tracked again up to that frame. If `shouldContinue` returns false, this stops and
  /// nothing is added.
  void addMaps(const SnapshotBuilder& builder, TrackSnapshot& snapshot,
               const TimeTravel::ShouldContinue& shouldContinue);
  /// Fills in a snapshot of any frame that can be shown, without changing the frame that is shown.
  /// Returns NotFound, Canceled (if `shouldContinue` returned false), or an error of reading the
  /// frame.
  Status describe(const SnapshotBuilder& builder, std::int64_t frame,
                  const TimeTravel::ShouldContinue& shouldContinue, TrackSnapshot& snapshot) {
    SnapshotBuilder::fillFromDefinition(definition(), snapshot);
    snapshot.cameraMotions = watches_.motionWatch().reports();
    snapshot.frameCount = input_.frameCount();
    snapshot.history = timeTravel().state();
    return builder.fillFromAnyFrame(run(), timeTravel(), frame, shouldContinue, snapshot);
  }

private:
  /// Returns the frame that the run is at; -1 before the first.
  std::int64_t headFrame() const { return current_.headFrame(); }
  TrackingRun& run() { return current_.run(); }
  const TrackingRun& run() const { return current_.run(); }
  TimeTravel& timeTravel() { return current_.timeTravel(); }
  const TimeTravel& timeTravel() const { return current_.timeTravel(); }
  /// Replaces the run by a new one that starts from scratch with another definition and counts its
  /// iterations from `iterations`. Returns false and changes nothing if the new run cannot be
  /// created.
  bool replaceRun(RunDefinition definition, std::int64_t iterations);
  /// Returns the project with the current definition.
  Project project() const { return definition().appliedTo(project_); }

  Result<FrameSetPtr> nextFrames();
  /// Takes the next frame set. Returns false at the end of the input, after an error, or if live
  /// cameras have delivered no image.
  bool takeFrame();
  void iterateFrame(FrameStep step = FrameStep::WholeFrame);
  void showNext() {
    playback_.advance(timeTravel().nextShowable(*playback_.viewedFrame()), headFrame());
  }
  /// Returns whether the next frame comes from live cameras, not from the past.
  bool takesFromCameras() const { return isLive() && !playback_.rerunRange(); }
  /// Notes the time of a frame set that was just taken, and the problems of live cameras.
  void noteTaken(const FrameSet& taken) {
    input_.noteTaken(taken);
    if (takesFromCameras()) {
      recorder_.setCameraProblems(input_.notices());
    }
  }
  void record() {
    recorder_.record(run(), current_.record());
    playback_.noteRecorded();
  }

  void rerun(std::int64_t from, const command::SetMethod* method, bool keepView);
  void changeBoxes(RunDefinition wanted);
  /// Replaces the corrections; `canApply` is true if the method can apply them. Usually, tracks
  /// again from the first frame whose corrections changed, and returns nothing. If the only change
  /// is that corrections were added in the frame that the run is at, returns the added ones, and
  /// the caller applies them to that frame.
  template <class Correction>
  std::vector<Correction> replaceCorrections(std::vector<Correction> RunDefinition::*member,
                                             const std::vector<Correction>& wanted, bool canApply);
  void note(const Error& error) { errors_.push_back(error); }
  void showFrame(const SnapshotBuilder& builder, bool quickly, TrackSnapshot& snapshot);

  Project project_; ///< project as it was opened; definition() takes precedence
  RunInput input_;
  FrameTapSlot& tap_;
  RunLog& log_;
  RunWithHistory current_; ///< contains no run if the project's run could not be created
  CameraWatches watches_;
  RunRecorder recorder_;
  std::array<FrameObserver*, 2> observers_{&watches_, &recorder_};
  Playback playback_;
  std::vector<Error> errors_;
};

} // namespace dewpoint::session
