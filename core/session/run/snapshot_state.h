// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/hold_state.h"
#include "core/session/run/snapshot.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace dewpoint::session {

/// The state a view shows for a target's status.
HoldState holdState(TargetStatus status);
/// The same of a target, and of a box whether it is hidden or not there yet.
HoldState holdState(const TargetSnapshot& target);
/// The worst of all targets: lost, searching, ambiguous, held; nothing to say without targets or
/// images.
HoldState holdState(const TrackSnapshot& snapshot);
/// The same of one camera: a box is followed in the camera of the box only.
HoldState holdState(const TrackSnapshot& snapshot, int camera);

/// The target whose reasons are worth saying: `preferred` if it exists, else the first that is not
/// held, else the first; null without any. Persons who have left come last.
const TargetSnapshot* targetToExplain(const TrackSnapshot& snapshot, int preferred);

/// The first held target that a camera sees: its estimate, or its box in that camera, lies within
/// the image. Null when none does.
const TargetSnapshot* heldTargetInView(const TrackSnapshot& snapshot, int camera);

/// What is wrong with a camera at present, by its notice; null: nothing that is known.
const Error* noticeOf(const TrackSnapshot& snapshot, int camera);

/// One person of a snapshot; valid as long as the snapshot.
struct PersonInSnapshot {
  std::size_t index = 0; ///< of the target
  const TargetSnapshot* target = nullptr;
  const PersonEstimate* estimate = nullptr; ///< of the target
};

/// All persons of a snapshot that are not absent, in the order of its targets.
std::vector<PersonInSnapshot> peopleIn(const TrackSnapshot& snapshot);

/// Index of the person whose hull is seen at a pixel of a camera, the one nearest to it; -1:
/// nobody.
int personSeenAt(const TrackSnapshot& snapshot, int camera, const Eigen::Vector2d& pixel);

} // namespace dewpoint::session
