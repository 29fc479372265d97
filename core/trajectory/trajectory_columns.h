// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/trajectory.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace dewpoint::trajectory {

/// One target of a trajectory as columns, with one row per row of TrajectoryColumns. In a row
/// without a sample of the target, floating-point values are NaN and all other values are 0.
struct TargetColumns {
  std::string target;
  std::vector<double> positions;   ///< x, y and z of each row; meters, world frame
  std::vector<double> covariances; ///< 9 values (3 x 3) of each row; m²
  /// x, y and z of the particle of highest weight, for each row; meters.
  std::vector<double> bestParticles;
  /// Existence probability of the target in each row. All are 0 if the trajectory comes from a
  /// file.
  std::vector<double> existenceProbabilities;
  std::vector<double> effectiveSampleSizes;
  std::vector<std::int32_t> cameraCounts; ///< number of cameras that show the target
  std::vector<std::uint8_t> validFlags;   ///< 1: the target is tracked, and its position is usable
  std::vector<std::uint8_t>
      ambiguousFlags; ///< 1: another object is about as likely to be the target
};

/// A trajectory as columns, for programs that work with arrays.
struct TrajectoryColumns {
  /// Frame number of each row, ascending; kNoFrame if the file has no frame numbers.
  std::vector<std::int64_t> frames;
  std::vector<double> times; ///< time of each row, seconds; NaN if the file has no times
  /// Columns of the targets, in the order of their first appearance.
  std::vector<TargetColumns> targets;
};

/// Returns the columns of all targets. They share the same rows: one for each frame in which any
/// target has a sample, or one for each time if the samples have no frame numbers.
TrajectoryColumns columnsOf(const Trajectory& trajectory);

} // namespace dewpoint::trajectory
