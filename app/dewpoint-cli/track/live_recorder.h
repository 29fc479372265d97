// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"
#include "core/trajectory/trajectory_writer.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::app {

/// Writes the trajectory of a running session to a file while it grows. Parts of the trajectory,
/// called takes, begin and end on request and are each also written to a file of their own.
/// Thread-safe.
class LiveRecorder {
public:
  /// Creates a recorder that writes nothing yet. `session` must outlive this object.
  LiveRecorder(const Session& session, std::filesystem::path folder);

  /// Creates the folder with an empty trajectory.csv, and a run.json that marks the run as not
  /// finished. Returns an error if a file cannot be written.
  Status begin();
  /// Writes the frames tracked since the last call, except for the newest frame, whose results may
  /// still change.
  Status update();
  /// Writes the final trajectory.csv and run.json, and ends the take.
  Status finish();

  /// Begins a take, a part of the trajectory that is also written to NAME.csv in the folder. An
  /// empty name becomes take-1, take-2 and so on. Returns BadValue if a take is in progress or the
  /// file exists.
  Status startTake(const std::string& name);
  /// Ends the take in progress. Returns BadValue if there is none.
  Status stopTake();
  /// Returns the name of the take in progress; empty if there is none.
  std::string takeName() const;

private:
  Status writeNew();
  Status writeAgain();

  const Session& session_;
  std::filesystem::path folder_;
  mutable std::mutex mutex_;
  TrajectoryHeader header_;
  std::optional<TrajectoryWriter> writer_;
  std::optional<TrajectoryWriter> takeWriter_;
  std::string take_;
  std::uint64_t generation_ = 0;
  std::size_t position_ = 0; ///< samples read from the session
  std::size_t written_ = 0;  ///< samples in trajectory.csv
};

} // namespace dewpoint::app
