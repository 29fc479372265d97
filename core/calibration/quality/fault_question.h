// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board.h"
#include "core/calibration/bundle/bundle_adjustment.h"
#include "core/calibration/quality/fault_evidence.h"

#include <array>
#include <optional>
#include <vector>

namespace dewpoint::calibration {

/// Smallest gain in log likelihood (Student's, 4 degrees of freedom) for which a hypothesis about
/// one or two cameras is reported. Origin not recorded.
inline constexpr double kLeastGain = 30.0;

/// Observations and entered data, before anything was solved or dropped.
struct FaultQuestion {
  /// Cameras: the initial rig with the given intrinsics. Bodies: as entered. A fixed state of a
  /// board is the floor (or a wall) that defines the world.
  BundleProblem problem;
  InitialRigSigma initialSigma; ///< standard deviations of the initial rig's poses
  std::vector<std::array<int, 2>> imageSizes = {}; ///< size of each video, pixels; empty: not known
  std::optional<BoardDescription> board = {};      ///< board of the first body
  bool focalUnknown = false; ///< whether focal lengths are to be estimated: they may differ
  /// Whether cameras run without synchronization, or offsets are to be estimated: a much larger
  /// gain is then required.
  bool unsynchronized = false;
};

} // namespace dewpoint::calibration
