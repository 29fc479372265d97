// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/recorded_run.h"
#include "core/trajectory/trajectory.h"
#include "core/trajectory/trajectory_columns.h"

#include <memory>
#include <optional>
#include <pybind11/pybind11.h>
#include <string>
#include <utility>

namespace dewpoint::app {

/// Trajectory for use from Python, stored both as samples and as columns to which NumPy arrays
/// refer.
struct TrajectoryHandle {
  explicit TrajectoryHandle(Trajectory from)
      : trajectory(std::move(from)), columns(columnsOf(trajectory)) {}

  Trajectory trajectory;
  TrajectoryColumns columns;
};
using TrajectoryPtr = std::shared_ptr<const TrajectoryHandle>;

/// Trajectory of a run, with the other results of the run.
struct RunHandle : TrajectoryHandle {
  explicit RunHandle(RecordedRun from)
      : TrajectoryHandle(std::move(from.trajectory)), run(std::move(from)) {}

  RecordedRun run; ///< all results except the trajectory, which is in the base class
};

/// Returns the index of a target that `key` gives by its name or by its index in `names`. Throws
/// KeyError for an unknown name, and IndexError for an index out of range.
std::size_t findTargetIndex(const pybind11::object& key, const std::vector<std::string>& names);

} // namespace dewpoint::app
