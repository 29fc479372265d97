// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/trajectory/path_filter.h"
#include "core/trajectory/trajectory.h"

#include <functional>
#include <span>
#include <vector>

namespace dewpoint::trajectory {

/// Options of smoothedTrajectory().
struct SmootherOptions {
  /// Longest gap that is filled, in seconds. After a longer gap, a new path begins.
  double maxFilledGapSeconds = 1.0;
  /// Called from time to time with the progress, 0 to 1; returning false ends the smoothing.
  std::function<bool(double)> progress;
};

/// Fits a path model to the run by maximum likelihood. It finds the most likely order and strength
/// of the motion, and the covariance factor that matches the scatter of the measurements. At most
/// the first 2,000 points of the paths are used. `shouldContinue`, if given, is called from time to
/// time; once it has returned false, the model found so far is returned.
PathModel fitPathModel(std::span<const std::vector<PathPoint>> paths,
                       const std::function<bool()>& shouldContinue = {});

/// Returns the trajectory smoothed over the whole run: each estimate uses all measurements before
/// and after it, and has the corresponding covariance.
///
/// Live estimates depend only on the past, and errors of neighboring estimates are correlated.
/// Smoothing therefore uses the independent measurement of each frame
/// (TrajectorySample::measurement) exactly once. If the trajectory was read from a file without
/// these measurements, the valid estimates are used as measurements, and their errors are treated
/// as independent. Between two measurements, the uncertainty increases and then decreases again. A
/// sample without a measurement becomes `isValid` if its smoothed position has a standard deviation
/// below 0.1 m in every direction.
///
/// If the measurements scatter less than their covariance predicts, the difference is attributed to
/// an error that all measurements share, for example because of light from one side or a slightly
/// wrong calibration. This error remains in the covariance, since smoothing cannot remove it.
///
/// Measurements after a gap are discarded as wrong if there are only a few of them and they agree
/// neither with the earlier nor with the later measurements. Estimates before the first
/// measurement, and those of targets with fewer than five measurements, are left unchanged. All
/// estimates are left unchanged if `progress` ended the smoothing.
Trajectory smoothedTrajectory(const Trajectory& live, const SmootherOptions& options = {});

} // namespace dewpoint::trajectory
