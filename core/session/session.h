// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame_source.h"
#include "core/project/project.h"
#include "core/session/frames/frame_tap.h"
#include "core/session/people/people_frame.h"
#include "core/session/run/box_track_file.h"
#include "core/session/run/snapshot.h"
#include "core/trajectory/trajectory.h"

#include <opencv2/core/mat.hpp>

#include <concepts>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::session {

/// What a run needs, chosen and wired by the application.
struct SessionInputs {
  Project project;
  std::unique_ptr<FrameSetSource> source;
  Trajectory truth; ///< empty when unknown
  /// Of the cameras (loadEmptyRooms); may be empty.
  std::vector<cv::Mat> emptyRooms = {};
  /// Bytes that going back in the run may take: images of live cameras, particles, copies.
  /// 0: 1 GB for live cameras, half of it for recordings.
  std::size_t historyBytes = 0;
};

/// What a person wants to work on: the project in a file (empty: the demo), or one that is in no
/// file as it is.
struct SessionRequest {
  template <std::convertible_to<std::filesystem::path> File>
  SessionRequest(File&& wanted) : file(std::forward<File>(wanted)) {} // NOLINT: implicit
  SessionRequest(Project wanted) : project(std::move(wanted)) {}      // NOLINT: implicit

  std::filesystem::path file;
  std::optional<Project> project;
};

/// The running machine: one tracking thread that takes frame sets, iterates the filters and
/// publishes snapshots. Every call returns at once; wishes are queued and obeyed at the next step.
class Session {
public:
  explicit Session(SessionInputs inputs);
  ~Session(); ///< stops the thread
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// `wake` is called from the tracking thread after a snapshot was published; it must only post.
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
  /// Samples from number `first` on, in place of those the reader has: what the trajectory gained
  /// since `position`, which begins at 0 and moves along as in logSince().
  struct SamplesPiece {
    std::size_t first = 0;
    std::vector<TrajectorySample> samples;
    bool restarted = false;
  };
  SamplesPiece samplesSince(std::uint64_t& generation, std::size_t& position) const;
  /// As samplesSince(), of the boxes that methods of family Boxes follow.
  struct BoxesPiece {
    std::size_t first = 0;
    std::vector<BoxSample> samples;
    bool restarted = false;
  };
  BoxesPiece boxesSince(std::uint64_t& generation, std::size_t& position) const;
  /// The boxes so far.
  BoxTrack boxTrack() const;
  /// The trajectory so far.
  Trajectory trajectory() const;
  /// Writes it as CSV; how many samples it held.
  Result<std::size_t> saveTrajectory(const std::filesystem::path& file) const;
  /// Writes trajectory.csv and run.json into a folder, which is made when it does not exist; with
  /// methods of family Boxes boxes.csv and boxes_mot.txt in place of the trajectory; of
  /// methods for people volumes.csv, hulls.csv and ground.csv too (PeopleWriter).
  Status saveRun(const std::filesystem::path& folder) const;
  /// All that is known of the people of the run; nothing for other methods.
  PeopleRecord peopleRecord() const;

  void play();
  void pause();
  void stepFrame();     ///< next frame with all its iterations, then pause
  void stepIteration(); ///< one filter iteration on the frame shown, then pause
  void restart(std::optional<std::uint64_t> seed = std::nullopt); ///< same seed unless given
  /// Another method with its parameters, from the start and with the same seed.
  void setMethod(const std::string& method, const ParameterValues& parameters);
  /// Another method that begins at this frame; what was tracked before it stays.
  void setMethodFrom(std::int64_t frame, const std::string& method,
                     const ParameterValues& parameters);
  /// Pauses and shows an earlier moment as it was (or a later one of a recording, untracked); the
  /// run itself stays where it is. Playing goes on from the moment shown: through what was recorded
  /// up to where the run stands, then tracking.
  void showFrame(std::int64_t frame);
  /// Shows where the run stands again.
  void backToHead();
  /// Tracks again from this frame on, as fast as it goes, up to where the run stood: with the
  /// parameters and colors of now. What was recorded from there on is replaced. Pausing stops it.
  void rerunFrom(std::int64_t frame);
  void setLikelihoodMapsWanted(bool wanted);
  void setParameters(const ParameterValues& parameters);
  /// Other colors or radii take effect at once; another number of targets means new beliefs.
  void setTargets(const std::vector<Target>& targets);
  /// Another calibration of the same cameras, from the next iteration on; what is believed stays. A
  /// rig with other image sizes, or another number of cameras, is ignored: that is another run.
  void setCameras(const CameraRig& rig);
  /// Other empty rooms of the same cameras (loadEmptyRooms), and the files they are from; what is
  /// believed stays.
  void setEmptyRooms(const std::vector<std::string>& files, const std::vector<cv::Mat>& rooms);
  void setMasksWanted(bool wanted);
  /// Hulls and level curves of persons (TargetSnapshot::shape).
  void setShapesWanted(bool wanted);
  /// Of methods for people, else nothing happens: somebody stands here (world x and y,
  /// metres), or is seen at a pixel of a camera; this identity is not there. At an earlier moment,
  /// the run is tracked again from there with that.
  void addPerson(const Eigen::Vector2d& place);
  void addPersonSeen(int camera, const Eigen::Vector2d& pixel);
  void removePerson(int identity);
  /// Gives every frame set that is taken from now on to `tap` too, in the tracking thread; an empty
  /// one ends it. Cameras that a person calibrates are seen so while they are tracked.
  void setFrameTap(FrameTap tap);

private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace dewpoint::session
