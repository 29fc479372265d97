// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/command.h"
#include "core/session/frames/frame_tap.h"
#include "core/session/people/people_frame.h"
#include "core/session/run/box_track_file.h"
#include "core/session/run/result_settings.h"
#include "core/session/run/run_report.h"
#include "core/session/run/snapshot.h"
#include "core/session/session_inputs.h"
#include "core/trajectory/trajectory.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::session {

/// All that a run leaves in a folder: a value of its own, to be written in any thread however the
/// run goes on.
struct RunRecord {
  Project project;
  RunFigures figures;
  PeopleRecord people; ///< its trajectory is that of other methods, too
  BoxTrack boxes;      ///< of methods that follow boxes

  /// Writes trajectory.csv and run.json into a folder, which is made when it does not exist; with
  /// methods that follow boxes boxes.csv and boxes_mot.txt instead of the trajectory; of methods
  /// for people volumes.csv, hulls.csv and ground.csv too (PeopleWriter).
  Status save(const std::filesystem::path& folder) const;

private:
  Status saveTables(const std::filesystem::path& folder) const;
};

/// The running machine: one tracking thread that takes frame sets, iterates the filters and
/// publishes snapshots. Every call returns at once; commands are queued and carried out at the next
/// step.
class Session {
public:
  explicit Session(SessionInputs inputs);
  ~Session(); ///< stops the thread
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// `wake` is called from the tracking thread after a snapshot was published; it should only post.
  /// It may read `newest`, but must not set another.
  void onSnapshot(std::function<void()> wake);
  /// The newest snapshot; never null.
  TrackSnapshotPtr newest() const;
  /// Iterations logged at or after `position` (a running count since the restart); `position` moves
  /// past them, and back to 0 first if the run was restarted meanwhile (returned `restarted`).
  struct LogPiece {
    std::vector<IterationRecord> records;
    bool restarted = false;
  };
  LogPiece logSince(std::uint64_t& generation, std::size_t& position) const;
  /// As logSince(), of the frames tracked: status, existence and missing cameras.
  struct FramePiece {
    std::vector<FrameRecord> records;
    bool restarted = false;
  };
  FramePiece framesSince(std::uint64_t& generation, std::size_t& position) const;
  /// Samples from number `first` on, instead of those the reader has: what the trajectory gained
  /// since `position`, which begins at 0 and moves along as in logSince().
  struct SamplesPiece {
    std::size_t first = 0;
    std::vector<TrajectorySample> samples;
    bool restarted = false;
  };
  SamplesPiece samplesSince(std::uint64_t& generation, std::size_t& position) const;
  /// As samplesSince(), of the boxes that methods that follow boxes follow.
  struct BoxesPiece {
    std::size_t first = 0;
    std::vector<BoxSample> samples;
    bool restarted = false;
  };
  BoxesPiece boxesSince(std::uint64_t& generation, std::size_t& position) const;
  /// The boxes so far.
  BoxTrack boxTrack() const;
  /// The results that other settings gave than those of the newest snapshot.
  OldResults oldResults() const;
  /// The trajectory so far.
  Trajectory trajectory() const;
  /// Writes it as CSV; how many samples it held.
  Result<std::size_t> saveTrajectory(const std::filesystem::path& file) const;
  /// What the run leaves, as it is now.
  RunRecord record() const;
  /// Writes it at once, see RunRecord.
  Status saveRun(const std::filesystem::path& folder) const;
  /// All that is known of the people of the run; nothing for other methods.
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
  void setEmptyRooms(const std::vector<std::string>& files, const std::vector<cv::Mat>& rooms) {
    send(command::SetEmptyRooms{files, rooms});
  }
  void setVolumeOfInterest(const std::optional<WorldBox>& volume) {
    send(command::SetVolumeOfInterest{volume});
  }
  /// From the start.
  void setMethod(const std::string& method, const ParameterValues& parameters) {
    send(command::SetMethod{method, parameters, std::nullopt});
  }
  void setMethodFrom(std::int64_t frame, const std::string& method,
                     const ParameterValues& parameters) {
    send(command::SetMethod{method, parameters, frame});
  }
  void showFrame(std::int64_t frame) { send(command::ShowFrame{frame}); }
  void backToHead() { send(command::BackToHead{}); }
  void rerunFrom(std::int64_t frame) { send(command::Rerun{frame}); }
  /// The same, while what is shown stays shown.
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
  /// Gives every frame set that is taken from now on to `tap` too, in the tracking thread; an empty
  /// one ends it. Cameras that a person calibrates are seen so while they are tracked.
  void setFrameTap(FrameTap tap);

private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace dewpoint::session
