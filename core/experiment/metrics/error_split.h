// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/error_statistics.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <vector>

namespace dewpoint::experiment {

/// Components of position errors. World frame, meters. The errors split in two ways: rmse² =
/// |bias|² + spread², and for each viewing direction in `meanViewBias` and `cameraBiases`, rmse² =
/// alongRms² + acrossRms².
struct ErrorSplit {
  /// Number of finite errors; other errors are ignored. If 0, all values are NaN.
  std::int64_t errorCount = 0;
  ErrorSummary summary; ///< RMSE, median, 95th percentile, maximum and bias of the errors
  double spread = 0.0;  ///< root mean squared distance from the mean error
  /// Error along (depth) and across (lateral) the mean of the cameras' viewing directions. Empty if
  /// there is no camera, or if the directions cancel (cameras that face each other).
  std::optional<CameraBias> meanViewBias;
  std::vector<CameraBias> cameraBiases; ///< error along and across the optical axis of each camera
};

/// Splits position errors (estimate minus truth, world frame, meters) into their components.
ErrorSplit splitErrors(const std::vector<Eigen::Vector3d>& errors,
                       const std::vector<TrajectoryCamera>& cameras);

} // namespace dewpoint::experiment
