// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/trajectory/path_filter.h"
#include "core/trajectory/trajectory.h"

#include <functional>
#include <span>
#include <vector>

namespace dewpoint::trajectory {

struct SmootherOptions {
  /// Gaps up to this length are filled, seconds; behind a longer one a new path begins.
  double longestGap = 1.0;
  /// Called now and then with how much is done, 0 to 1; false ends the smoothing.
  std::function<bool(double)> progress;
};

/// How a target moved and how good its measurements were, found by maximum likelihood over the run:
/// the likeliest order of motion with its strength, and the factor on the covariances that the
/// measurements' scatter shows. At most the first 2,000 instants are used. `goesOn`, when given, is
/// called from time to time; once it has returned false, the model found so far is returned.
PathModel fitPathModel(std::span<const std::vector<PathPoint>> paths,
                       const std::function<bool()>& goesOn = {});

/// The trajectory as it is known after the run: each target's estimates become those that all
/// measurements before and after allow, with their covariance. A live estimate knows only the past,
/// and errors of neighboring ones are alike; so what each frame alone measured (`seen`) is used
/// instead, each measurement once. Frames without a measurement carry none: between two of them the
/// ellipsoid grows and shrinks again, and such a frame becomes `valid` while it says something
/// (standard deviation below 0.1 m). What the measurements scatter less than they state is taken
/// for an error that they share (light from one side, a calibration that is a little off): it stays
/// in the covariance, no smoothing removes it. Where a file has no `seen`, valid estimates are
/// taken as if their errors were independent. A few measurements behind a gap, where neither those
/// before nor those after agree with them, are a mistake and dropped. Estimates before the first
/// measurement, and of targets with fewer than five, stay as they are; all do when `progress` ended
/// it.
Trajectory smoothed(const Trajectory& live, const SmootherOptions& options = {});

} // namespace dewpoint::trajectory
