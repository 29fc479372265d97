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

/// A correction from which its target is to be tracked back in time.
struct BackwardOrder {
  RunDefinition definition; ///< of the run
  PositionCorrection from;  ///< one of its corrections
  /// What the run believed of all targets before that frame, and in it.
  std::vector<TrajectorySample> believed;
};

/// How far the work is, 0 to 1; false: it is not wanted any more.
using BackwardProgress = std::function<bool(double)>;

/// Where a target was before a person said where it is. The frames before the correction are
/// tracked from the last to the first by a run of its own, which begins with the correction and
/// with what is believed of the other targets there. It ends where the target is lost, after ten
/// seconds in which it is found where it was believed to be anyway (all before that is taken to be
/// right), where it leaves what was believed by a jump, and at an earlier correction by a person.
///
/// Where it found the target elsewhere comes as corrections, about two per second, with
/// `trackedFrom` set: a run that tracks on from the first of them is where the target was. Empty
/// when nothing was believed wrongly, for live sources, and for methods that take no corrections.
/// Errors of the source and of TrackingRun::create(); Cancelled when it was not wanted any more.
Result<std::vector<PositionCorrection>> trackBackwards(FrameSetSource& source,
                                                       const BackwardOrder& order, int threads,
                                                       const BackwardProgress& progress);

/// The project with what trackBackwards() finds for each of its corrections by a person, in the
/// order of their frames, in place of what it has of the kind. What is believed before each is
/// found out by tracking up to it. `emptyRooms` as RunDefinition::of().
Result<Project> trackedBackwards(const Project& project, FrameSetSource& source,
                                 const std::vector<cv::Mat>& emptyRooms, int threads,
                                 const BackwardProgress& progress);

} // namespace dewpoint::session
