// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/growing_file.h"
#include "core/trajectory/trajectory.h"

#include <filesystem>
#include <utility>

namespace dewpoint::trajectory {

/// Writes a trajectory as tidy CSV: `#` header, a line of column names, one row per target and
/// frame. Every row goes to the operating system at once, so that what a killed run wrote can be
/// read. Numbers are the shortest that read back exactly, with a point in any locale.
class TrajectoryWriter {
public:
  /// Creates (or empties) the file and writes its header; FileUnwritable if that cannot be done.
  static Result<TrajectoryWriter> create(const std::filesystem::path& path,
                                         const TrajectoryHeader& header);

  Status write(const TrajectorySample& sample);
  /// Closes the file; nothing may be written after it.
  Status finish();

private:
  TrajectoryWriter(GrowingFile file, TrajectoryHeader header)
      : file_(std::move(file)), header_(std::move(header)) {}

  GrowingFile file_;
  TrajectoryHeader header_;
};

/// Writes a whole trajectory at once; a file of that name is replaced, or stays as it was.
Status writeTrajectory(const Trajectory& trajectory, const std::filesystem::path& path);

} // namespace dewpoint::trajectory
