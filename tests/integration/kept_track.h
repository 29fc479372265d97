// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/trajectory.h"
#include "tests/integration/watched_source.h"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace dewpoint::tests {

/// Shows whether the target was tracked whenever two cameras showed it.
struct KeptTrack {
  std::int64_t due = 0;          ///< number of frames in which the target must be tracked
  std::vector<std::string> lost; ///< texts about due frames without a correct estimate
  double largestError = 0.0;     ///< meters, in frames that are due
};

/// Compares a trajectory with what the images show. A frame is due if it is the last of
/// `steadySets` successive frame sets that each have good images of at least two cameras. In a
/// frame that is due, the target must be tracked at most `errorBound` meters from the truth.
/// `truth`: returns the position at a tick, meters.
KeptTrack keptTrack(const std::map<std::int64_t, SetRecord::Entry>& sets,
                    const Trajectory& trajectory,
                    const std::function<Eigen::Vector3d(std::int64_t)>& truth, int steadySets,
                    double errorBound);

} // namespace dewpoint::tests
