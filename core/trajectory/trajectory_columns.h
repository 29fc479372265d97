// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/trajectory.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace dewpoint::trajectory {

/// One target of a trajectory as columns, one row per frame of TrajectoryColumns. Where the target
/// has no sample in a frame, numbers are not a number and all else is 0.
struct TargetColumns {
  std::string target;
  std::vector<double> positions;   ///< rows x y z, meters, world frame
  std::vector<double> covariances; ///< rows of 9: 3 x 3, m²
  std::vector<double> best;        ///< rows x y z of the particle of highest weight, meters
  std::vector<double> existence;   ///< probability; 0 for a trajectory from a file
  std::vector<double> effectiveSampleSize;
  std::vector<std::int32_t> cameras;   ///< that show the target
  std::vector<std::uint8_t> valid;     ///< 1: the cameras confirm the target
  std::vector<std::uint8_t> ambiguous; ///< 1: something else may be the target about as well
};

/// A trajectory as columns: what programs that calculate with whole arrays read.
struct TrajectoryColumns {
  std::vector<std::int64_t> frames; ///< rising; kNoFrame where the file has none
  std::vector<double> times;        ///< seconds, one per row; not a number where the file has none
  std::vector<TargetColumns> targets; ///< in the order in which they come up first
};

/// The columns of all targets over the same rows: the frames in which any of them has a sample, or
/// the instants where the samples have no frames.
TrajectoryColumns columnsOf(const Trajectory& trajectory);

} // namespace dewpoint::trajectory
