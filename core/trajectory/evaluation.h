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

/// Comparison of an estimate with the truth for one target, in meters. The statistics cover the
/// frames after convergence, or all frames if the estimate never converged; `rmseAll` covers every
/// compared frame.
struct Evaluation {
  std::string target;
  double rmse = 0.0;
  double median = 0.0;
  double p95 = 0.0; ///< interpolated linearly between order statistics
  double max = 0.0;
  double rmseAll = 0.0;
  /// Share of these frames whose true position is in the stated 95 % ellipsoid.
  double inside95 = 0.0;
  Eigen::Vector3d bias = Eigen::Vector3d::Zero(); ///< mean of estimate minus truth
  std::vector<CameraBias> cameras;
  std::int64_t framesCompared = 0; ///< frames of the truth that have an estimate
  /// Number of frames before the first run of kConvergedRun consecutive frames within the gate; 0
  /// if the estimate converged at once. Empty if it never converged.
  std::optional<std::int64_t> framesToConverge;
  /// After convergence: error beyond the gate, or estimate missing or not valid.
  std::int64_t lostFrames = 0;
  /// Frames of the truth, in the range of the estimate, without an estimate.
  std::int64_t missing = 0;
};

/// Number of consecutive frames within the gate that count as convergence.
inline constexpr int kConvergedRun = 5;
/// Default gate in meters: the motion sigma of the paper.
inline constexpr double kDefaultGate = 0.03;

/// Compares each target of `estimate` with the truth of the same name, or with the only truth there
/// is. Targets without a truth are left out. Frames are matched by number, or by time within half a
/// frame if one trajectory has no frame numbers. Only truth between the first and the last estimate
/// counts. Returns NotFound if no target has a truth, and Mismatch if there is no common frame.
Result<std::vector<Evaluation>> evaluate(const Trajectory& estimate, const Trajectory& truth,
                                         double gate = kDefaultGate);

} // namespace dewpoint::trajectory
