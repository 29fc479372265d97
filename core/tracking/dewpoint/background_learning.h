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

// Selection of what the backgrounds are learned from, given the present estimates of the targets
// (docs/method-dewpoint.md, section 2).

/// Returns the areas of a camera's image in which nothing is learned: targets and distractors,
/// their shadows and reflections.
std::vector<BackgroundModel::Hidden> hiddenByObjects(const TrackedObjects& objects,
                                                     std::size_t camera);

/// Returns whether the positions of all targets are so certain that anything else of their color is
/// not a target.
bool noTargetIsElsewhere(const TrackedObjects& objects, std::size_t cameraCount,
                         const std::vector<SphereEstimate>& estimates);

/// A target is at this position (meters, world): what was found to be empty there is not.
void forgetFamiliarPixelsAt(const TrackedObject& object, const Eigen::Vector3d& position,
                            FrameImages& images);

/// Counts for how long each target has not been found; `interval` seconds since the last frame.
/// Once one has not been for `patience` seconds it may have been anywhere all the time.
void forgetFamiliarPixelsOfLost(TrackedObjects& objects, FrameImages& images, double interval,
                                double patience);

} // namespace dewpoint::tracking
