// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/frame_source.h"
#include "core/project/project.h"
#include "core/session/run/run_definition.h"
#include "core/trajectory/trajectory.h"

#include <functional>
#include <vector>

namespace dewpoint::session {

/// A correction from which its target is to be tracked backward in time.
struct BackwardOrder {
  RunDefinition definition; ///< definition of the run
  PositionCorrection from;  ///< one of the run's corrections
  /// Estimates of all targets in the run before and at the frame of the correction.
  std::vector<TrajectorySample> believed;
};

/// Receives the progress, 0 to 1; returning false cancels the work.
using BackwardProgress = std::function<bool(double)>;

/// Finds the positions of a target before a correction made by the user. A separate run tracks the
/// frames before the correction from last to first. It starts with the correction and with the
/// estimates of the other targets in that frame. It ends where the target is lost, where the target
/// agrees with the former estimates for ten seconds (all earlier estimates are then considered
/// correct), where it leaves the former estimates by a jump, and at an earlier correction by the
/// user.
///
/// Where it found the target elsewhere comes as corrections, about two per second, with
/// `trackedFrom` set: a run that tracks on from the first of them is where the target was. Empty
/// when nothing was believed wrongly, for live sources, and for methods that take no corrections.
/// Errors of the source and of TrackingRun::create(); Canceled when it was not wanted any more.
Result<std::vector<PositionCorrection>> trackBackwards(FrameSetSource& source,
                                                       const BackwardOrder& order, int threads,
                                                       const BackwardProgress& progress);

/// The project with what trackBackwards() finds for each of its corrections by a person, in the
/// order of their frames, in place of what it has of the kind. What is believed before each is
/// found out by tracking up to it. `backgroundImages` as RunDefinition::of().
Result<Project> trackedBackwards(const Project& project, FrameSetSource& source,
                                 const std::vector<cv::Mat>& backgroundImages, int threads,
                                 const BackwardProgress& progress);

} // namespace dewpoint::session
