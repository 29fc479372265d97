// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/trajectory/trajectory.h"

#include <filesystem>

namespace dewpoint::trajectory {

/// Frame number of samples from a file without a frame column.
inline constexpr std::int64_t kNoFrame = -1;

/// Reads a trajectory or truth file by its column names. The required columns are `x_m`, `y_m`,
/// `z_m`, and either `frame` or `time_s`. Without `time_s`, times are NaN. All other columns are
/// optional. An empty cell is read as NaN. An incomplete last line, left by a killed run, is
/// ignored. Errors name the line and the column.
Result<Trajectory> readTrajectory(const std::filesystem::path& path);

} // namespace dewpoint::trajectory
