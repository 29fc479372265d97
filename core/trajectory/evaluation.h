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

/// Estimate against truth for one target, in meters. The statistics cover the frames from
/// convergence on (all, if it never converged); `rmseAll` covers every compared frame.
struct Evaluation {
  std::string target;
  double rmse = 0.0;
  double median = 0.0;
  double p95 = 0.0; ///< linear between order statistics
  double max = 0.0;
  double rmseAll = 0.0;
  double inside95 = 0.0; ///< share of these frames whose truth is in the stated 95 % ellipsoid
  Eigen::Vector3d bias = Eigen::Vector3d::Zero(); ///< mean of estimate minus truth
  std::vector<CameraBias> cameras;
  std::int64_t framesCompared = 0; ///< frames of the truth that have an estimate
  /// Frames before the first of kConvergedRun frames in a row within the gate; 0: from the start.
  std::optional<std::int64_t> framesToConverge;
  std::int64_t lostFrames = 0; ///< after convergence: beyond the gate, missing or not valid
  std::int64_t missing = 0;    ///< frames of the truth, in the estimate's range, without estimate
};

/// Frames in a row within the gate that count as converged.
inline constexpr int kConvergedRun = 5;
/// Default gate, meters: the paper's motion sigma.
inline constexpr double kDefaultGate = 0.03;

/// Compares each target of `estimate` with the truth of the same name (or the only truth there
/// is; targets without one are left out), by frame number, or by time within half a frame if either
/// has no frame numbers. Only truth between the first and the last estimate counts. NotFound if no
/// target has a truth, Mismatch if no frame is common.
Result<std::vector<Evaluation>> evaluate(const Trajectory& estimate, const Trajectory& truth,
                                         double gate = kDefaultGate);

} // namespace dewpoint::trajectory
