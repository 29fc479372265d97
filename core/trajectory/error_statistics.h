// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/trajectory.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace dewpoint::trajectory {

/// Position error relative to one camera, in meters: along its optical axis (depth) and across it.
struct CameraBias {
  std::string cameraName;
  double alongAxisBias = 0.0;  ///< mean error along the axis; positive: estimated too far away
  double acrossAxisBias = 0.0; ///< length of the mean error across the axis
  double alongAxisRms = 0.0;   ///< root mean square error along the axis
  double acrossAxisRms = 0.0;  ///< root mean square error across the axis
};

/// Statistics of error lengths and the mean error vector, in meters.
struct ErrorSummary {
  double rmse = 0.0;
  double medianError = 0.0;
  double p95 = 0.0; ///< 95th percentile, interpolated linearly between order statistics
  double maxError = 0.0;
  Eigen::Vector3d bias = Eigen::Vector3d::Zero(); ///< mean of estimate minus truth
};

/// Computes the statistics of errors (estimate minus truth, world frame, meters). Requires at least
/// one error.
ErrorSummary summarize(const std::vector<Eigen::Vector3d>& errors);

/// Computes the mean and the root mean square of errors along and across a camera's optical axis.
/// Requires at least one error (estimate minus truth, world frame, meters).
CameraBias computeCameraBias(const TrajectoryCamera& camera,
                             const std::vector<Eigen::Vector3d>& errors);

/// Returns the root mean square of the error lengths, in meters. Requires at least one error.
double rootMeanSquare(const std::vector<Eigen::Vector3d>& errors);

} // namespace dewpoint::trajectory
