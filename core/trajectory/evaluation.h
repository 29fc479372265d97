// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/trajectory/error_statistics.h"
#include "core/trajectory/trajectory.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::trajectory {

/// Comparison of an estimate with the truth for one target, in meters. The gate is the largest
/// error at which an estimate counts as being on the target. The estimate has converged after
/// kConvergedFrames successive frames with errors within the gate. The statistics cover the frames
/// from convergence on, or all frames if the estimate never converged. Only `rmseOfAllFrames`
/// covers every compared frame.
struct Evaluation {
  std::string target;
  double rmse = 0.0;            ///< root mean square error
  double medianError = 0.0;     ///< median error
  double p95 = 0.0;             ///< 95th percentile, interpolated linearly between order statistics
  double maxError = 0.0;        ///< largest error
  double rmseOfAllFrames = 0.0; ///< root mean square error of all compared frames
  /// Fraction of the frames in which the true position lies inside the estimated 95 % ellipsoid, 0
  /// to 1. Only frames that the statistics cover are counted.
  double fractionInside95Ellipsoid = 0.0;
  Eigen::Vector3d bias = Eigen::Vector3d::Zero(); ///< mean of estimate minus truth
  std::vector<CameraBias> cameraBiases;
  std::int64_t comparedFrameCount = 0; ///< number of ground-truth frames that have an estimate
  /// Number of frames before the first kConvergedFrames successive frames with errors within the
  /// gate. 0 if the estimate converged immediately; empty if it never converged.
  std::optional<std::int64_t> convergenceFrameCount;
  /// Number of frames after convergence in which the error exceeds the gate, or the estimate is
  /// missing or not valid.
  std::int64_t lostFrameCount = 0;
  /// Number of ground-truth frames within the range of the estimate that have no estimate.
  std::int64_t missingFrameCount = 0;
};

/// Number of successive frames with errors within the gate that count as convergence.
inline constexpr int kConvergedFrames = 5;
/// Default gate in meters: the motion sigma used by Barrera et al. (2005).
inline constexpr double kDefaultGate = 0.03;

/// Compares each target of `estimate` with the ground truth of the same name, or with the only
/// target in `truth` if there is just one. Targets without ground truth are omitted. Frames are
/// matched by number, or by time within half a frame if one trajectory has no frame numbers. Only
/// ground truth between the first and the last estimate is compared. Returns NotFound if no target
/// has ground truth, and Mismatch if there is no common frame.
Result<std::vector<Evaluation>> evaluate(const Trajectory& estimate, const Trajectory& truth,
                                         double gate = kDefaultGate);

} // namespace dewpoint::trajectory
