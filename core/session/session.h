// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/command.h"
#include "core/session/frames/frame_tap.h"
#include "core/session/frames/live_set.h"
#include "core/session/log_update.h"
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

/// All results of a run that can be saved to a folder. This is an independent copy, so any thread
/// can write it to the folder while the run continues.
struct RunRecord {
  Project project;
  RunStatistics figures;
  PeopleRecord people; ///< for methods that do not track people, it contains only the trajectory
  BoxTrack boxes;      ///< boxes, for methods that track boxes

  /// Writes trajectory.csv and run.json to a folder, which is created if necessary. Methods that
  /// track boxes write boxes.csv and boxes_mot.txt instead of the trajectory. Methods for people
  /// also write volumes.csv, hulls.csv and ground.csv (PeopleWriter).
  Status save(const std::filesystem::path& folder) const;

private:
  Status saveTables(const std::filesystem::path& folder) const;
};

/// A running session with one tracking thread, which takes frame sets, iterates the filters and
/// publishes snapshots. Every call returns immediately; commands are queued and executed at the
/// next step.
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
  /// Returns the iterations logged at or after `position`, and moves `position` past them.
  /// `position` counts the iterations since the last restart. `generation` identifies the run that
  /// the caller knows; both start at 0. If the run has restarted or gone back since the last call,
  /// `generation` is updated, all iterations are returned, and `restarted` is set in the result.
  LogUpdate<IterationRecord> iterationsSince(std::uint64_t& generation,
                                             std::size_t& position) const;
  /// Like iterationsSince(), but for tracked frames: status, existence probability and missing
  /// cameras.
  LogUpdate<FrameRecord> framesSince(std::uint64_t& generation, std::size_t& position) const;
  /// Returns the samples added to the trajectory since `position`. Both arguments start at 0 and
  /// are updated as in iterationsSince().
  LogUpdate<TrajectorySample> samplesSince(std::uint64_t& generation, std::size_t& position) const;
  /// Like samplesSince(), but for the boxes of methods that track boxes.
  LogUpdate<BoxSample> boxesSince(std::uint64_t& generation, std::size_t& position) const;
  /// Returns all boxes of the run so far.
  BoxTrack boxTrack() const;
  /// Returns which results came from settings other than those of the newest snapshot.
  OldResults oldResults() const;
  /// Returns the trajectory so far.
  Trajectory trajectory() const;
  /// Writes the trajectory as CSV and returns the number of samples.
  Result<std::size_t> saveTrajectory(const std::filesystem::path& file) const;
  /// Returns the results of the run so far.
  RunRecord record() const;
  /// Returns which images of live cameras the run has tracked since its last start or restart.
  std::vector<LiveSet> liveSets() const;
  /// Writes the results of the run so far to a folder; see RunRecord.
  Status saveRun(const std::filesystem::path& folder) const;
  /// Returns the trajectory so far and, if the method tracks people, the people of its frames.
  PeopleRecord peopleRecord() const;

  /// Sends a command; command.h describes each.
  void send(Command command);
  void play() { send(command::Play{}); }
  void pause() { send(command::Pause{}); }
  void stepFrame() { send(command::StepFrame{}); }
  void stepIteration() { send(command::StepIteration{}); }
  void restart(std::optional<std::uint64_t> seed = std::nullopt) { send(command::Restart{seed}); }
  void setParameters(const ParameterValues& parameters) {
    send(command::SetParameters{parameters});
  }
  void setTargets(const std::vector<Target>& targets) { send(command::SetTargets{targets}); }
  void setCameras(const CameraRig& rig) { send(command::SetCameras{rig}); }
  void setBackgroundImages(const std::vector<std::string>& files,
                           const std::vector<cv::Mat>& images) {
    send(command::SetBackgroundImages{files, images});
  }
  void setVolumeOfInterest(const std::optional<WorldBox>& volume) {
    send(command::SetVolumeOfInterest{volume});
  }
  /// Changes the method and starts again from the first frame.
  void setMethod(const std::string& method, const ParameterValues& parameters) {
    send(command::SetMethod{method, parameters, std::nullopt});
  }
  /// Changes the method from this frame on. The results of earlier frames are kept.
  void setMethodFrom(std::int64_t frame, const std::string& method,
                     const ParameterValues& parameters) {
    send(command::SetMethod{method, parameters, frame});
  }
  void showFrame(std::int64_t frame) { send(command::ShowFrame{frame}); }
  void returnToNewestFrame() { send(command::ReturnToNewestFrame{}); }
  void rerunFrom(std::int64_t frame) { send(command::Rerun{frame}); }
  /// Like rerunFrom(), but the frame that is shown does not change.
  void rerunKeepingView(std::int64_t frame) { send(command::Rerun{frame, true}); }
  /// Requests a snapshot of any frame that can be shown, as showFrame() would show it, but without
  /// changing what is shown. For exports.
  void describeFrame(command::DescribeFrame request) { send(std::move(request)); }
  void setMasksShown(bool shown) { send(command::ShowMasks{shown}); }
  void setLikelihoodMapsShown(bool shown) { send(command::ShowMaps{shown}); }
  void setShapesShown(bool shown) { send(command::ShowShapes{shown}); }
  void setFilterThreads(int threads) { send(command::SetThreads{threads}); }
  void setPace(const Pace& pace) { send(command::SetPace{pace}); }
  void setBoardShown(bool shown) { send(command::ShowBoard{shown}); }
  void setPersonCorrections(const std::vector<PersonCorrection>& people) {
    send(command::SetPersonCorrections{people});
  }
  void setCorrections(const std::vector<PositionCorrection>& corrections) {
    send(command::SetCorrections{corrections});
  }
  /// Adds the time from a live estimate until the window has painted it, in seconds, to the
  /// statistics.
  void countDrawing(double seconds);
  /// Sets a function that also receives every frame set taken from now on; an empty tap removes it.
  /// It is called in the tracking thread. A calibration uses it to access the cameras while
  /// tracking continues.
  void setFrameTap(FrameTap tap);

private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace dewpoint::session
