// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/background/background_model.h"
#include "core/tracking/dewpoint/frame_images.h"
#include "core/tracking/dewpoint/tracked_objects.h"
#include "core/tracking/track_estimate.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace dewpoint::tracking {

// Functions that select the pixels from which the backgrounds are learned, given the present
// estimates of the targets (docs/method-dewpoint.md, section 2).

/// Returns the areas of a camera's image in which nothing is learned: targets and distractors, with
/// their shadows and reflections.
std::vector<BackgroundModel::ExcludedCircle> excludedCircles(const TrackedObjects& objects,
                                                             std::size_t camera);

/// Returns whether the positions of all targets are so certain that no other pixel with a target's
/// color can show a target.
bool noTargetIsElsewhere(const TrackedObjects& objects, std::size_t cameraCount,
                         const std::vector<SphereEstimate>& estimates);

/// Makes the background models forget pixels of the target's color that were learned as background
/// at `position` (meters, world frame). Call it if a target was found at this position, because
/// these pixels were learned by mistake.
void forgetFamiliarPixelsAt(const TrackedObject& object, const Eigen::Vector3d& position,
                            FrameImages& images);

/// If a target has not been found for `patience` seconds, makes the background models forget all
/// pixels of the target's color that were learned as background, because these pixels may have
/// shown the target. `interval` is the time in seconds since the last frame. It is added to the
/// time for which each target has not been found.
void forgetFamiliarPixelsOfLostTargets(TrackedObjects& objects, FrameImages& images,
                                       double interval, double patience);

} // namespace dewpoint::tracking
