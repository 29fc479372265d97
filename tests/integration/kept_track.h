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

/// Whether the target was tracked whenever two cameras showed it.
struct KeptTrack {
  std::int64_t due = 0;          ///< frames in which the target must be tracked
  std::vector<std::string> lost; ///< of them, those in which it was not
  double largestError = 0.0;     ///< meters, in frames that are due
};

/// Compares a trajectory with what the images show. The target must be tracked, at most
/// `errorBound` meters from the truth, in each frame that is the last of `steadySets` sets each of
/// which has good images of two cameras, without interruption. `truth`: position at a tick, meters.
KeptTrack keptTrack(const std::map<std::int64_t, SetRecord::Entry>& sets,
                    const Trajectory& trajectory,
                    const std::function<Eigen::Vector3d(std::int64_t)>& truth, int steadySets,
                    double errorBound);

} // namespace dewpoint::tests
