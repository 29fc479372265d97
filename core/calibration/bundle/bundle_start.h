// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/bundle/bundle_adjustment.h"

#include <cstdint>
#include <vector>

namespace dewpoint::calibration {

/// Usable parts of a problem, and start values of its bodies.
struct BundleStart {
  std::vector<BundleState> states; ///< with start values where `stateUsed`
  std::vector<bool> stateUsed;
  std::vector<bool> observationUsed;
  /// For each observation, the states (of the same body, ascending in time) between which its point
  /// is interpolated; empty if it has the time of its own state.
  std::vector<std::vector<std::size_t>> knots;
  bool moving = false; ///< whether any observation is interpolated between states
};

/// Triangulates bodies without start values, and drops observations without information: points
/// seen by one camera only, boards with fewer than four points, images between instants whose
/// neighbors are missing. Errors: numbers that are not finite, indices out of range, a camera with
/// too few observations.
Result<BundleStart> startBundle(const BundleProblem& problem);

} // namespace dewpoint::calibration
