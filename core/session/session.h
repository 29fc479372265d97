// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/command.h"
#include "core/session/frames/frame_tap.h"
#include "core/session/log_piece.h"
#include "core/session/people/people_frame.h"
#include "core/session/run/box_track_file.h"
#include "core/session/run/result_settings.h"
#include "core/session/run/run_report.h"
#include "core/session/session_inputs.h"
#include "core/session/snapshot/snapshot.h"
#include "core/trajectory/trajectory.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::session {

/// All results that a run saves to a folder. It is an independent copy, which any thread can write
/// while the run continues.
struct RunRecord {
  Project project;
  RunFigures figures;
  PeopleRecord people; ///< its trajectory is also used with other methods
  BoxTrack boxes;      ///< with methods that track boxes

  /// Writes trajectory.csv and run.json to a folder, which is created if necessary. Methods that
  /// track boxes write boxes.csv and boxes_mot.txt instead of the trajectory. Methods for people
  /// also write volumes.csv, hulls.csv and ground.csv (PeopleWriter).
  Status save(const std::filesystem::path& folder) const;

private:
  Status saveTables(const std::filesystem::path& folder) const;
};

/// A running session with one tracking thread, which takes frame sets, iterates the filters and
/// publishes snapshots. Every call returns at once; commands are queued and executed at the next
/// step.
class Session {
public:
  explicit Session(SessionInputs inputs);
  ~Session(); ///< stops the thread
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Sets the function that the tracking thread calls after publishing a snapshot. It should only
  /// post an event. It may call newest(), but not onSnapshot().
  void onSnapshot(std::function<void()> wake);
  /// Returns the newest snapshot; never null.
  TrackSnapshotPtr newest() const;
  /// Iterations logged at or after `position` (a running count since the restart); `position` moves
  /// past them, and back to 0 first if the run was restarted meanwhile (returned `restarted`).
  LogPiece<IterationRecord> logSince(std::uint64_t& generation, std::size_t& position) const;
  /// As logSince(), of the frames tracked: status, existence and missing cameras.
  LogPiece<FrameRecord> framesSince(std::uint64_t& generation, std::size_t& position) const;
  /// What the trajectory gained since `position`, which begins at 0 and moves along as in
  /// logSince().
  LogPiece<TrajectorySample> samplesSince(std::uint64_t& generation, std::size_t& position) const;
  /// As samplesSince(), of the boxes that methods that follow boxes follow.
  LogPiece<BoxSample> boxesSince(std::uint64_t& generation, std::size_t& position) const;
  /// The boxes so far.
  BoxTrack boxTrack() const;
  /// Returns which results came from other settings than those of the newest snapshot.
  OldResults oldResults() const;
  /// Returns the trajectory so far.
  Trajectory trajectory() const;
  /// Writes the trajectory as CSV and returns the number of samples.
  Result<std::size_t> saveTrajectory(const std::filesystem::path& file) const;
  /// Returns the present results of the run.
  RunRecord record() const;
  /// Writes the present results at once; see RunRecord.
  Status saveRun(const std::filesystem::path& folder) const;
  /// Returns all data about the people of the run; empty with other methods.
  PeopleRecord peopleRecord() const;

  /// Sends a command; command.h describes each.
  void send(Command command);
  void play() { send(command::Play{}); }
  void pause() { send(command::Pause{}); }
  void stepFrame() { send(command::StepFrame{}); }
  void stepIteration() { send(command::StepIteration{}); }
  void restart(std::optional<std::uint64_t> seed = std::nullopt) { send(command::Restart{seed}); }
  void setParameters(const ParameterValues& parameters) { send(command::Configure{parameters}); }
  void setTargets(const std::vector<Target>& targets) { send(command::SetTargets{targets}); }
  void setCameras(const CameraRig& rig) { send(command::SetCameras{rig}); }
  void setBackgroundImages(const std::vector<std::string>& files,
                           const std::vector<cv::Mat>& rooms) {
    send(command::SetBackgroundImages{files, rooms});
  }
  void setVolumeOfInterest(const std::optional<WorldBox>& volume) {
    send(command::SetVolumeOfInterest{volume});
  }
  /// Changes the method and starts again from the first frame.
  void setMethod(const std::string& method, const ParameterValues& parameters) {
    send(command::SetMethod{method, parameters, std::nullopt});
  }
  /// Changes the method from this frame on; earlier results are kept.
  void setMethodFrom(std::int64_t frame, const std::string& method,
                     const ParameterValues& parameters) {
    send(command::SetMethod{method, parameters, frame});
  }
  void showFrame(std::int64_t frame) { send(command::ShowFrame{frame}); }
  void backToHead() { send(command::BackToHead{}); }
  void rerunFrom(std::int64_t frame) { send(command::Rerun{frame}); }
  /// As rerunFrom(), but the displayed frame stays.
  void renewFrom(std::int64_t frame) { send(command::Rerun{frame, true}); }
  void setMasksWanted(bool wanted) { send(command::ShowMasks{wanted}); }
  void setLikelihoodMapsWanted(bool wanted) { send(command::ShowMaps{wanted}); }
  void setShapesWanted(bool wanted) { send(command::ShowShapes{wanted}); }
  void setFilterThreads(int threads) { send(command::SetThreads{threads}); }
  void setPace(const Pace& pace) { send(command::SetPace{pace}); }
  void setBoardShown(bool shown) { send(command::ShowBoard{shown}); }
  void setPeople(const std::vector<PersonCorrection>& people) { send(command::SetPeople{people}); }
  void setCorrections(const std::vector<PositionCorrection>& corrections) {
    send(command::SetCorrections{corrections});
  }
  /// Also passes every frame set taken from now on to `tap`, in the tracking thread; an empty tap
  /// ends this. It gives a calibration access to the cameras while they are being tracked.
  void setFrameTap(FrameTap tap);

private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace dewpoint::session
