// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/trajectory.h"

#include <map>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Assigns true targets to tracked targets that look the same, such as balls of one color. The
/// names of such tracked targets are a matter of chance, so the true targets are assigned to them
/// by position. Each group in `alike` lists the names of targets that look the same. Within a
/// group, the assignment with the smallest sum of median distances is chosen. It applies to the
/// whole trajectory, so two targets that are exchanged during the run still count as an error.
/// Frames are matched by number.
///
/// The result maps the name of a tracked target to the name of its true target, where the two names
/// differ. It is empty if all names agree. If not all targets of a group can be assigned, because
/// one of them was never tracked or has no truth, the names of this group are kept.
std::map<std::string, std::string>
truthNamesByPosition(const Trajectory& estimate, const Trajectory& truth,
                     const std::vector<std::vector<std::string>>& alike);

/// Returns the truth with each target renamed to its tracked target, so that evaluate() compares
/// the two. `truthNames` is the result of truthNamesByPosition().
Trajectory namedAsTracked(Trajectory truth, const std::map<std::string, std::string>& truthNames);

} // namespace dewpoint::experiment
