// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/trajectory.h"

#include <map>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Assigns true targets to tracked targets that nothing but their positions tells apart, such as
/// balls of one color: which of them has which name is a matter of chance. Each group in `alike`
/// lists the names of such targets. Within a group, each tracked target gets the true one so that
/// the sum of the median distances is smallest; one assignment holds for the whole trajectory, so
/// that an exchange on the way still counts as an error. Frames are matched by number. Returns the
/// true name for each tracked name whose true target has another name; empty if names fit.
std::map<std::string, std::string>
truthNamesByPosition(const Trajectory& estimate, const Trajectory& truth,
                     const std::vector<std::vector<std::string>>& alike);

/// Returns the truth with the names of the tracked targets in place of its own, so that evaluate()
/// compares them. `truthNames` is the result of truthNamesByPosition().
Trajectory namedAsTracked(Trajectory truth, const std::map<std::string, std::string>& truthNames);

} // namespace dewpoint::experiment
