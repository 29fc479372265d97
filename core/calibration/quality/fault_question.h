// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board.h"
#include "core/calibration/bundle/bundle_adjustment.h"
#include "core/calibration/quality/fault_evidence.h"

#include <array>
#include <optional>
#include <vector>

namespace dewpoint::calibration {

/// What a hypothesis about one or two cameras must gain in log-likelihood (Student's, 4 degrees of
/// freedom) to be named. Origin not recorded.
inline constexpr double kLeastGain = 30.0;

/// What was seen and what was stated about it, before anything was solved or dropped.
struct FaultQuestion {
  /// Cameras: the initial rig with the lenses as given. Bodies: as typed. A fixed state of
  /// a board is the floor (or a wall) that defines the world.
  BundleProblem problem;
  InitialRigSigma initialSigma;                    ///< how far the initial rig may be off
  std::vector<std::array<int, 2>> imageSizes = {}; ///< of the videos, pixels; empty: not known
  std::optional<BoardDescription> board = {};      ///< of the first body
  bool focalUnknown = false; ///< focal lengths are to be found: they may differ
  /// Cameras run freely, or offsets are to be found: only what explains far more is named.
  bool unsynchronized = false;
};

} // namespace dewpoint::calibration
