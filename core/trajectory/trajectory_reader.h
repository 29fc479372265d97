// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/trajectory/trajectory.h"

#include <filesystem>

namespace dewpoint::trajectory {

/// Frame of a sample whose file has no frame column.
inline constexpr std::int64_t kNoFrame = -1;

/// Reads a trajectory, or a truth file, by the names of its columns. Needed: `frame` or `time_s`
/// (the time is not a number if there is none), `x_m`, `y_m`, `z_m`; all others may be missing. An
/// empty cell is not a number. A last line without its end, as a killed run leaves it, is ignored.
/// Errors name line and column.
Result<Trajectory> readTrajectory(const std::filesystem::path& path);

} // namespace dewpoint::trajectory
