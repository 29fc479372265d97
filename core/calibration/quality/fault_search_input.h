// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board.h"
#include "core/calibration/bundle/bundle_adjustment.h"
#include "core/calibration/quality/fault_evidence.h"

#include <array>
#include <optional>
#include <vector>

namespace dewpoint::calibration {

/// Minimum gain in log likelihood (Student's t, 4 degrees of freedom) for reporting a hypothesis
/// about one or two cameras. Origin not recorded.
inline constexpr double kMinGain = 30.0;

/// Input of findFaults(): the observations and the data entered by the user, before anything is
/// estimated or left out.
struct FaultSearchInput {
  /// The cameras are those of the initial rig, with the given intrinsics. The bodies are as entered
  /// by the user. A fixed state of a board represents the floor (or a wall) that defines the world.
  BundleProblem problem;
  InitialRigSigma initialSigma; ///< standard deviations of the poses in the initial rig
  /// Image size of each video, pixels; empty: unknown.
  std::vector<std::array<int, 2>> imageSizes = {};
  std::optional<BoardDescription> board = {}; ///< board represented by the first body
  /// True if the focal lengths are not known, so that a wrong focal length is no fault.
  bool isFocalUnknown = false;
  /// True if the cameras are not synchronized, or if time offsets are to be estimated. A fault is
  /// then reported only if its gain is much larger than kMinGain.
  bool isUnsynchronized = false;
};

} // namespace dewpoint::calibration
