// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/command.h"
#include "core/session/frames/frame_tap.h"
#include "core/session/frames/live_set.h"
#include "core/session/log/log_update.h"
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

/// All results of a run that can be saved. This is an independent copy, so any thread can save it
/// while the run continues.
struct RunRecord {
  Project project;
  RunStatistics statistics;
  PeopleRecord people; ///< the trajectory and, for methods that track people, the people
  BoxTrack boxes;      ///< boxes, for methods that track boxes

  /// Writes trajectory.csv and run.json to a folder, which is created if necessary. For methods
  /// that track boxes, writes boxes.csv and boxes_mot.txt instead of the trajectory. For methods
  /// that track people, also writes volumes.csv, hulls.csv and ground.csv (PeopleWriter).
  Status save(const std::filesystem::path& folder) const;

private:
  Status saveTables(const std::filesystem::path& folder) const;
};

/// Running session with one tracking thread, which takes frame sets, iterates the filters and
/// publishes snapshots. Commands return immediately: they are queued and executed at the next step.
class Session {
public:
  explicit Session(SessionInputs inputs);
  ~Session(); ///< stops the thread
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Sets the function that the tracking thread calls after publishing a snapshot. `wake` should
  /// only post an event. It may call newest(), but not onSnapshot().
  void onSnapshot(std::function<void()> wake);
  /// Returns the newest snapshot; never null.
  TrackSnapshotPtr newest() const;
  /// Returns the iterations logged at or after `position`, and moves `position` past them.
  /// `position` counts the iterations since the last restart. `generation` identifies the run that
  /// the caller knows; both start at 0. If the run has restarted or gone back since the last call,
  /// `generation` is updated, all iterations are returned, and `restarted` is set in the result.
  LogUpdate<IterationRecord> iterationsSince(std::uint64_t& generation,
                                             std::size_t& position) const;
  /// Returns the records of the frames tracked since `position` (status, existence probability,
  /// missing cameras), and moves `position` past them. Returns all records, with a new
  /// `generation`, if the run has restarted or gone back. Both arguments start at 0.
  LogUpdate<FrameRecord> framesSince(std::uint64_t& generation, std::size_t& position) const;
  /// Returns the samples added to the trajectory since `position`, and moves `position` past them.
  /// Returns all samples, with a new `generation`, if the run has restarted or gone back. Both
  /// arguments start at 0.
  LogUpdate<TrajectorySample> samplesSince(std::uint64_t& generation, std::size_t& position) const;
  /// Returns the bounding boxes added since `position`, and moves `position` past them. Returns all
  /// boxes, with a new `generation`, if the run has restarted or gone back. Empty unless the method
  /// tracks boxes.
  LogUpdate<BoxSample> boxesSince(std::uint64_t& generation, std::size_t& position) const;
  /// Returns all bounding boxes of the run so far; empty unless the method tracks boxes.
  BoxTrack boxTrack() const;
  /// Returns which results of the run came from settings other than those of the newest snapshot.
  OldResults oldResults() const;
  /// Returns the trajectory so far.
  Trajectory trajectory() const;
  /// Writes the trajectory as CSV and returns the number of samples.
  Result<std::size_t> saveTrajectory(const std::filesystem::path& file) const;
  /// Returns the results of the run so far.
  RunRecord record() const;
  /// Returns which images of live cameras the run has tracked since its last start or restart.
  std::vector<LiveFrameRecord> liveFrameRecords() const;
  /// Writes the results of the run so far (trajectory.csv, run.json and others) to a folder, as
  /// RunRecord::save() does.
  Status saveRun(const std::filesystem::path& folder) const;
  /// Returns the trajectory so far and, if the method tracks people, the people of its frames.
  PeopleRecord peopleRecord() const;

  /// Sends a command to the tracking thread; command.h describes each command.
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
  /// Changes the tracking method and starts again from the first frame.
  void setMethod(const std::string& method, const ParameterValues& parameters) {
    send(command::SetMethod{method, parameters, std::nullopt});
  }
  /// Changes the tracking method from this frame on. The results of earlier frames are kept.
  void setMethodFrom(std::int64_t frame, const std::string& method,
                     const ParameterValues& parameters) {
    send(command::SetMethod{method, parameters, frame});
  }
  void showFrame(std::int64_t frame) { send(command::ShowFrame{frame}); }
  void returnToNewestFrame() { send(command::ReturnToNewestFrame{}); }
  void rerunFrom(std::int64_t frame) { send(command::Rerun{frame}); }
  /// Tracks again from this frame on. The frame that is shown does not change.
  void rerunKeepingView(std::int64_t frame) { send(command::Rerun{frame, true}); }
  /// Requests a snapshot of any frame that can be shown, without changing what is shown. Exports
  /// use this.
  void describeFrame(command::DescribeFrame request) { send(std::move(request)); }
  void setMasksShown(bool shown) { send(command::ShowMasks{shown}); }
  void setLikelihoodMapsShown(bool shown) { send(command::ShowMaps{shown}); }
  void setBodyShapesShown(bool shown) { send(command::ShowBodyShapes{shown}); }
  void setFilterThreadCount(int threads) { send(command::SetThreadCount{threads}); }
  void setPace(const Pace& pace) { send(command::SetPace{pace}); }
  void setCalibrationBoardShown(bool shown) { send(command::ShowCalibrationBoard{shown}); }
  void setPersonCorrections(const std::vector<PersonCorrection>& corrections) {
    send(command::SetPersonCorrections{corrections});
  }
  void setCorrections(const std::vector<PositionCorrection>& corrections) {
    send(command::SetCorrections{corrections});
  }
  /// Adds to the statistics the time, in seconds, from a live estimate until the window has painted
  /// it.
  void addDrawingTime(double seconds);
  /// Sets a function that receives every frame set taken from now on; an empty function removes it.
  /// The function is called in the tracking thread. A calibration uses this to access the images
  /// while tracking continues.
  void setFrameTap(FrameTap tap);

private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace dewpoint::session
