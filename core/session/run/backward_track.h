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

/// Request to track a target backward in time, starting at a correction made by the user.
struct BackwardRequest {
  RunDefinition definition;           ///< settings of the run in which the correction was made
  PositionCorrection startCorrection; ///< correction to start from, one of the run's corrections
  /// Estimates of all targets in the run up to and including the frame of the correction.
  std::vector<TrajectorySample> estimates;
};

/// Function that receives the progress, 0 to 1. If it returns false, the work is canceled.
using BackwardProgress = std::function<bool(double)>;

/// Finds the positions of a target before a correction made by the user. A separate run tracks the
/// frames before the correction from last to first. This run starts with the corrected position and
/// with the estimates of the other targets in that frame. It ends at an earlier correction by the
/// user, when the target is lost or jumps away from the former estimates, or when it has agreed
/// with the former estimates for ten seconds. In the last case, all earlier estimates are
/// considered correct.
///
/// Returns corrections for the frames in which the target was found elsewhere, about two per
/// second, with `trackedFrom` set. A run that applies them follows the target from the first of
/// these frames on. Returns none if no estimate was wrong, for live sources, and for methods that
/// cannot apply corrections. Returns the errors of the source and of TrackingRun::create(), and
/// Canceled if `progress` canceled the work.
Result<std::vector<PositionCorrection>> trackBackwards(FrameSetSource& source,
                                                       const BackwardRequest& order, int threads,
                                                       const BackwardProgress& progress);

/// Returns the project with the corrections found by trackBackwards() from each correction made by
/// the user. These corrections replace all earlier ones that came from tracking backward. The
/// recording is tracked up to each correction to get the estimates before it. `backgroundImages`
/// has one image per camera, as returned by loadBackgroundImages(), or is empty.
Result<Project> withBackwardCorrections(const Project& project, FrameSetSource& source,
                                        const std::vector<cv::Mat>& backgroundImages, int threads,
                                        const BackwardProgress& progress);

} // namespace dewpoint::session
