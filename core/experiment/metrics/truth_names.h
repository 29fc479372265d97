// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/trajectory.h"

#include <map>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Assigns true targets, by position, to tracked targets that look the same, such as balls of one
/// color. Which of these gets which name is a matter of chance, so names cannot be compared. Each
/// group in `alike` lists the names of targets that look the same. Within a group, the assignment
/// with the smallest sum of median distances is chosen for the whole trajectory; two targets that
/// are exchanged during the run therefore still count as an error. Frames are matched by number.
///
/// Returns a map from the name of a tracked target to the name of its true target, for targets
/// whose two names differ. The map is empty if all names agree. If a target of a group was never
/// tracked or has no truth, the names of this group are kept.
std::map<std::string, std::string>
truthNamesByPosition(const Trajectory& estimate, const Trajectory& truth,
                     const std::vector<std::vector<std::string>>& alike);

/// Returns the truth with each target renamed to its tracked target, so that evaluate() compares
/// the two. `truthNames` maps the name of a tracked target to the name of its true target; see
/// truthNamesByPosition().
Trajectory withTrackedNames(Trajectory truth, const std::map<std::string, std::string>& truthNames);

} // namespace dewpoint::experiment
