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

/// Choices for a take.
struct TakeOptions {
  RawStorage raw = RawStorage::Jpeg;
  std::string notes = {}; ///< free text, kept in take.json
  /// Number of the take; nothing: the next one after all takes in the folder.
  std::optional<int> number = std::nullopt;
};

/// A take so far.
struct TakeStatus {
  struct CameraStatus {
    std::string name;
    std::string video; ///< file name in the folder
    RecordedCounts counts;
    PreRollStatus preRoll; ///< images of its feed at the start of the take
  };

  int number = 0; ///< from 1
  std::filesystem::path folder;
  std::string notes;
  double seconds = 0.0;              ///< since its start, or its whole duration
  double preRoll = 0.0;              ///< seconds recorded before its start
  std::vector<CameraStatus> cameras; ///< in the order of the project
  std::uint64_t freeBytes = 0;       ///< left on the disk
  /// Why take.json or project.toml could not be written.
  std::optional<Error> problem;
};

/// Records the streams of all cameras of a project into one new folder, take-001, take-002, ...:
///
/// - for each camera a video, NAME.mkv, and its capture times, NAME.csv (StreamRecording);
/// - project.toml, a project of these recordings with the calibration, targets, colors and
/// parameters
///   of the live project. It names the cameras that have sent images so far, so that it can be
///   opened during the take, and after the program was killed;
/// - take.json: number, notes, date, and how many images of each camera were recorded and dropped.
class TakeRecorder {
public:
  /// Longest time before the start of a take that can be kept, in seconds.
  static constexpr double kLongestPreRoll = 60.0;
  /// Most memory for the images before the start, of all cameras together: 512 MiB.
  static constexpr std::size_t kPreRollBytes = std::size_t{512} << 20;

  /// Makes feeds keep their last images, `seconds` long, for a take that starts later. The cameras
  /// share kPreRollBytes equally. 0 keeps nothing.
  static void setPreRoll(const std::vector<EncodedFeedPtr>& feeds, double seconds);

  /// Creates the folder in `parent` and starts to record, beginning with what the feeds have kept
  /// (EncodedFeed::setPreRoll()). `feeds`: those of the project's cameras,
  /// in their order. Errors: FileUnwritable, Mismatch if the project is not live, and those of
  /// makeTakeFolder().
  static Result<std::unique_ptr<TakeRecorder>> start(const Project& project,
                                                     const std::vector<EncodedFeedPtr>& feeds,
                                                     const std::filesystem::path& parent,
                                                     const TakeOptions& options);
  TakeRecorder(const TakeRecorder&) = delete;
  TakeRecorder& operator=(const TakeRecorder&) = delete;
  /// Stops if that was not done.
  ~TakeRecorder();

  /// May be called from any thread.
  TakeStatus status() const;
  /// Replaces the notes, also after the take has ended. May be called from any thread. Error:
  /// FileUnwritable.
  Status setNotes(const std::string& notes);
  /// Adds the results of the live run to a take that has ended: trajectory.csv, run.json and which
  /// images made up each frame in its folder `live`, and live.toml, the project with the settings
  /// at the end of the run (compareReplay()). Does nothing if nothing was tracked, or if the
  /// take has no image of it. Error: FileUnwritable.
  Status addLiveRun(const LiveRun& live) const;
  /// Ends the take in less than about 1 s and completes its files. Returns the first problem of a
  /// file.
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
