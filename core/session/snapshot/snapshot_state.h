// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"
#include "core/session/snapshot/tracking_state.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace dewpoint::session {

/// Returns the camera with this index in a snapshot's rig; null if the index is out of range.
const Camera* cameraOf(const TrackSnapshot& snapshot, int camera);

/// Returns the state that views show for a target's status.
TrackingState trackingState(TargetStatus status);
/// Returns the state that views show for a target. A box can also be hidden or not exist yet.
TrackingState trackingState(const TargetSnapshot& target);
/// Returns the worst state of all targets. From worst to best, the states are: lost, searching,
/// ambiguous, hidden, held (confirmed by the cameras). Returns NoImages if there are no images,
/// NoTarget if there are no targets, and NotTracked for a frame that was not tracked.
TrackingState trackingState(const TrackSnapshot& snapshot);
/// Returns the worst state of the targets in the view of one camera. A box counts only for the
/// camera in which it is tracked.
TrackingState trackingState(const TrackSnapshot& snapshot, int camera);

/// Returns the target whose state is explained to the user: the one with index `preferred` if it
/// exists, otherwise the first that is not held (confirmed by the cameras), otherwise the first.
/// Persons who have left come last. Null if there is no target.
const TargetSnapshot* targetToExplain(const TrackSnapshot& snapshot, int preferred);

/// Returns the first target that is held (confirmed by the cameras) and whose estimate, or whose
/// box in this camera, lies within the camera's image. Null if there is none.
const TargetSnapshot* trackedTargetInView(const TrackSnapshot& snapshot, int camera);

/// Returns the pixel of a camera at which a target's position appears, even if it lies outside the
/// image. Returns nothing if the position is behind the camera.
std::optional<Eigen::Vector2d> pixelOf(const TrackSnapshot& snapshot, int camera,
                                       const Eigen::Vector3d& position);

/// Returns the estimate of a target's position; nothing for a frame that was not tracked.
std::optional<Gaussian3> positionEstimate(const TrackSnapshot& snapshot, int target);

/// Returns the index of the target whose estimate is closest to a pixel of a camera, among those of
/// the first `count` targets that the views show. Returns -1 if none is at most `reach` pixels
/// away.
int targetIndexNear(const TrackSnapshot& snapshot, int count, int camera,
                    const Eigen::Vector2d& pixel, double reach);

/// Returns the notice about the current problem of a camera; null if no problem is known.
const Error* noticeOf(const TrackSnapshot& snapshot, int camera);

/// One person of a snapshot; valid as long as the snapshot exists.
struct PersonInSnapshot {
  std::size_t targetIndex = 0; ///< index of the target
  const TargetSnapshot* target = nullptr;
  const PersonEstimate* estimate = nullptr; ///< estimate of the target
};

/// Returns all persons of a snapshot that are not absent, in the order of its targets.
std::vector<PersonInSnapshot> peopleIn(const TrackSnapshot& snapshot);

/// Returns the index of the person whose hull covers a pixel of a camera; -1 if there is none. Of
/// several, returns the one closest to the camera.
int personIndexAt(const TrackSnapshot& snapshot, int camera, const Eigen::Vector2d& pixel);

} // namespace dewpoint::session
