// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/bundle/bundle_adjustment.h"

#include <cstdint>
#include <vector>

namespace dewpoint::calibration {

/// Usable parts of a bundle problem, with start values for its bodies.
struct BundleStart {
  std::vector<BundleState> states; ///< states, with start values where `isStateUsed` is true
  std::vector<bool> isStateUsed;
  std::vector<bool> isObservationUsed;
  /// For each observation, the states (of the same body, ascending in time) between which its point
  /// is interpolated. Empty if the point is not interpolated, because the image was taken at the
  /// time of the observation's state.
  std::vector<std::vector<std::size_t>> interpolationStates;
  bool hasInterpolation = false; ///< true if any observation is interpolated between states
};

/// Returns the usable parts of a problem, with start values for all bodies. Bodies without start
/// values are triangulated. Observations without information are dropped: points that only one
/// camera sees, boards with fewer than four observed points, and images that were taken between
/// states if neighboring states are missing. Fails if a number is not finite, an index is out of
/// range, or a camera has too few observations.
Result<BundleStart> initializeBundle(const BundleProblem& problem);

} // namespace dewpoint::calibration
