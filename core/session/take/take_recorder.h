// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/gstreamer/encoded_feed.h"
#include "core/capture/gstreamer/stream_recording.h"
#include "core/project/project.h"
#include "core/session/take/live_run.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace dewpoint::session {

/// Options for recording a take (a recording of all cameras).
struct TakeOptions {
  RawStorage rawStorage = RawStorage::Jpeg;
  std::string notes = {}; ///< free text, kept in take.json
  /// Number of the take; if not set, the next one after all takes in the folder.
  std::optional<int> number = std::nullopt;
};

/// State of a take (a recording of all cameras) that is in progress or has ended.
struct TakeStatus {
  struct CameraStatus {
    std::string name;
    std::string videoFile; ///< file name of the video in the folder
    RecordedCounts counts;
    PreRollStatus preRoll; ///< images kept from before the start of the take
  };

  int takeNumber = 0; ///< number of the take, at least 1
  std::filesystem::path folder;
  std::string notes;
  double durationSeconds = 0.0; ///< time since the start, or the duration of a take that has ended
  double preRollSeconds = 0.0;  ///< recorded time before the start, in seconds
  std::vector<CameraStatus> cameras; ///< state of each camera, in project order
  std::uint64_t freeBytes = 0;       ///< free space on the disk
  /// Error that prevented take.json or project.toml from being written; empty if there was none.
  std::optional<Error> problem;
};

/// Records the streams of all cameras of a project into one new folder, take-001, take-002, ...:
///
/// - for each camera a video, NAME.mkv, and its capture times, NAME.csv (StreamRecording);
/// - project.toml, a project of these recordings with the calibration, targets, colors and
///   parameters of the live project. It contains the cameras that have sent images so far, so users
///   can open it during the take or after a crash;
/// - take.json: number, notes, date, and how many images of each camera were recorded and dropped.
class TakeRecorder {
public:
  /// Longest pre-roll, in seconds: the time before the start of a take whose images are kept.
  static constexpr double kMaxPreRollSeconds = 60.0;
  /// Memory limit for the images kept from before the start, for all cameras together: 512 MiB.
  static constexpr std::size_t kPreRollBytes = std::size_t{512} << 20;

  /// Makes `feeds`, the streams of encoded images of the cameras, keep their images of the last
  /// `seconds` seconds for a take that starts later; 0 keeps none. The cameras share kPreRollBytes
  /// of memory equally.
  static void setPreRoll(const std::vector<EncodedFeedPtr>& feeds, double seconds);

  /// Creates the folder of the take in `parent` and starts to record, beginning with the images
  /// that the feeds have kept (EncodedFeed::setPreRoll()). `feeds` has one feed per camera, in
  /// project order. Returns FileUnwritable, Mismatch if not all cameras of the project are live,
  /// and the errors of makeTakeFolder().
  static Result<std::unique_ptr<TakeRecorder>> start(const Project& project,
                                                     const std::vector<EncodedFeedPtr>& feeds,
                                                     const std::filesystem::path& parent,
                                                     const TakeOptions& options);
  TakeRecorder(const TakeRecorder&) = delete;
  TakeRecorder& operator=(const TakeRecorder&) = delete;
  /// Calls stop() if the take has not ended.
  ~TakeRecorder();

  /// Returns the current state of the take. May be called from any thread.
  TakeStatus status() const;
  /// Replaces the notes of the take, even after it has ended. May be called from any thread.
  /// Returns FileUnwritable if take.json cannot be written.
  Status setNotes(const std::string& notes);
  /// Adds the results of the live run to a take that has ended, so that compareReplay() can compare
  /// them with the results of tracking the recorded images again. Writes trajectory.csv, run.json
  /// and a list of the images in each frame to the folder `live` of the take, and the project with
  /// the settings at the end of the run to live.toml. Does nothing if nothing was tracked, or if
  /// the take has none of the run's images. Returns FileUnwritable if a file cannot be written.
  Status addLiveRun(const LiveRun& live) const;
  /// Ends the take and completes its files, which takes up to about 1 s. Returns the first error of
  /// writing a file.
  Status stop();

private:
  using Clock = std::chrono::steady_clock;

  TakeRecorder(Project project, std::filesystem::path folder, int number, TakeOptions options);
  void watch(const std::stop_token& stop);
  /// Notes what the feeds have kept and returns the time zero of the take: that of the oldest
  /// image.
  Clock::time_point keepPreRoll(const std::vector<EncodedFeedPtr>& feeds);
  /// Writes project.toml if further cameras have sent images.
  void updateProject();
  Status writeNotes(bool finished) const;
  void note(const Status& written);

  Project project_; ///< of the recordings of all cameras
  std::filesystem::path folder_;
  int number_;
  TakeOptions options_;
  std::string date_; ///< local time at the start
  Clock::time_point begin_ = Clock::now();
  std::vector<PreRollStatus> preRolls_; ///< of the cameras, at the start
  double preRoll_ = 0.0;                ///< seconds
  std::vector<std::unique_ptr<StreamRecording>> recordings_;
  std::vector<bool> named_; ///< whether project.toml has the camera; used by one thread at a time

  mutable std::mutex notesMutex_; ///< held while take.json is written
  mutable std::mutex mutex_;      ///< guards the members below, and the notes in `options_`
  std::optional<double> duration_;
  std::optional<Error> problem_;

  std::jthread watch_; ///< last, so that it ends first
};

} // namespace dewpoint::session
