// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/growing_file.h"
#include "core/trajectory/trajectory.h"

#include <filesystem>
#include <utility>

namespace dewpoint::trajectory {

/// Writes a trajectory as tidy CSV: `#` header, a line of column names, and one row per target and
/// frame. Each row is passed to the operating system immediately. All rows written so far can
/// therefore be read even if the run is killed. Numbers are written in the shortest representation
/// that round-trips, with a decimal point in every locale.
class TrajectoryWriter {
public:
  /// Creates or truncates the file and writes its header. Returns FileUnwritable if this fails.
  static Result<TrajectoryWriter> create(const std::filesystem::path& path,
                                         const TrajectoryHeader& header);

  /// Appends a row.
  Status write(const TrajectorySample& sample);
  /// Closes the file. No further writes are allowed.
  Status finish();

private:
  TrajectoryWriter(GrowingFile file, TrajectoryHeader header)
      : file_(std::move(file)), header_(std::move(header)) {}

  GrowingFile file_;
  TrajectoryHeader header_;
};

/// Writes a whole trajectory. An existing file is replaced, or left unchanged if writing fails.
Status writeTrajectory(const Trajectory& trajectory, const std::filesystem::path& path);

} // namespace dewpoint::trajectory
