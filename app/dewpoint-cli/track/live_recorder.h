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

/// Writes the trajectory of a running session while it grows, and takes: parts of it that begin and
/// end on request, each in a file of its own. Thread-safe.
class LiveRecorder {
public:
  /// `session` must outlive this object. Nothing is written yet.
  LiveRecorder(const Session& session, std::filesystem::path folder);

  /// Creates the folder with an empty trajectory.csv and a run.json that says that the run did not
  /// finish.
  Status begin();
  /// Writes what was tracked since the last call, except for the newest frame.
  Status update();
  /// Writes the final trajectory.csv and run.json, and ends the take.
  Status finish();

  /// Begins a take, which is written to NAME.csv in the folder; an empty name becomes take-1,
  /// take-2 and so on. BadValue if a take is in progress or the file exists.
  Status startTake(const std::string& name);
  /// Ends the take. BadValue if there is none.
  Status stopTake();
  /// Returns the name of the take in progress; empty: none.
  std::string take() const;

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
