// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/bundle/bundle_adjustment.h"

#include <cstdint>
#include <vector>

namespace dewpoint::calibration {

/// What of a problem can be used, and where its bodies are at the start.
struct BundleStart {
  std::vector<BundleState> states; ///< with start values where `stateUsed`
  std::vector<bool> stateUsed;
  std::vector<bool> observationUsed;
  /// Per observation: the states (of the same body, rising in time) that its point is followed
  /// through; empty where it is of its state's own instant.
  std::vector<std::vector<std::size_t>> knots;
  bool moving = false; ///< some observation is followed through several states
};

/// Triangulates what has no start, and drops what says nothing: points seen by one camera only,
/// boards with fewer than four points, images between instants whose neighbors are missing.
/// Errors: numbers that are not finite, indices out of range, a camera with too few observations.
Result<BundleStart> startBundle(const BundleProblem& problem);

} // namespace dewpoint::calibration
