// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/recorded_run.h"
#include "core/trajectory/trajectory.h"
#include "core/trajectory/trajectory_columns.h"

#include <memory>
#include <optional>
#include <pybind11/pybind11.h>
#include <string>
#include <utility>

namespace dewpoint::app {

/// A trajectory as Python reads it: the samples, and the same as columns over which arrays are
/// laid.
struct TrajectoryHandle {
  explicit TrajectoryHandle(Trajectory from)
      : trajectory(std::move(from)), columns(columnsOf(trajectory)) {}

  Trajectory trajectory;
  TrajectoryColumns columns;
};
using TrajectoryPtr = std::shared_ptr<const TrajectoryHandle>;

/// The trajectory of a run, and what else is known of the run.
struct RunHandle : TrajectoryHandle {
  explicit RunHandle(RecordedRun from)
      : TrajectoryHandle(std::move(from.trajectory)), run(std::move(from)) {}

  RecordedRun run; ///< without its trajectory
};

/// The number of one of `count` names: the name itself, or its number. Throws KeyError, IndexError.
std::size_t targetNumber(const pybind11::object& key, const std::vector<std::string>& names);

} // namespace dewpoint::app
