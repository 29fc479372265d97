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
struct BackwardRequest {
  RunDefinition definition; ///< definition of the run
  PositionCorrection from;  ///< correction to start from, one of the run's corrections
  /// Estimates of all targets in the run up to and including the frame of the correction.
  std::vector<TrajectorySample> estimates;
};

/// Receives the progress, 0 to 1; returning false cancels the work.
using BackwardProgress = std::function<bool(double)>;

/// Finds the positions of a target before a correction made by the user. A separate run tracks the
/// frames before the correction from last to first. It starts with the correction and with the
/// estimates of the other targets in that frame. It ends at an earlier correction by the user, when
/// the target is lost, when it jumps away from the former estimates, or when it has agreed with
/// them for ten seconds. After such an agreement, all earlier estimates are considered correct.
///
/// Returns corrections for the frames in which it found the target elsewhere, about two per second,
/// with `trackedFrom` set. A run that continues from the first of them is at the correct position
/// of the target. Returns none if no estimate was wrong, for live sources, and for methods that
/// cannot apply corrections. Returns the errors of the source and of TrackingRun::create(), and
/// Canceled if `progress` canceled the work.
Result<std::vector<PositionCorrection>> trackBackwards(FrameSetSource& source,
                                                       const BackwardRequest& order, int threads,
                                                       const BackwardProgress& progress);

/// Returns the project with the results of trackBackwards() for each correction made by the user,
/// in frame order. These results replace all earlier corrections that came from tracking backward.
/// The estimates before each correction are computed by tracking the recording up to it.
/// `backgroundImages` are as for RunDefinition::of().
Result<Project> withBackwardCorrections(const Project& project, FrameSetSource& source,
                                        const std::vector<cv::Mat>& backgroundImages, int threads,
                                        const BackwardProgress& progress);

} // namespace dewpoint::session
