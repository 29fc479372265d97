// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/trajectory.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace dewpoint::trajectory {

/// The error as one camera sees it, in meters: along its optical axis (depth) and across it.
struct CameraBias {
  std::string name;
  double alongBias = 0.0;  ///< mean error along the axis; positive: estimated too far away
  double acrossBias = 0.0; ///< length of the mean error across the axis
  double alongRms = 0.0;
  double acrossRms = 0.0;
};

/// Errors as lengths, in meters, and their mean as a vector.
struct ErrorSummary {
  double rmse = 0.0;
  double median = 0.0;
  double p95 = 0.0; ///< linear between order statistics
  double max = 0.0;
  Eigen::Vector3d bias = Eigen::Vector3d::Zero(); ///< mean of estimate minus truth
};

/// Sums up errors (estimate minus truth, world, meters; at least one).
ErrorSummary summarize(const std::vector<Eigen::Vector3d>& errors);

/// Splits errors (estimate minus truth, world, meters; at least one) along and across the axis.
CameraBias cameraBias(const TrajectoryCamera& camera, const std::vector<Eigen::Vector3d>& errors);

/// Root of the mean squared length; at least one error.
double rootMeanSquare(const std::vector<Eigen::Vector3d>& errors);

} // namespace dewpoint::trajectory
