// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/fault.h"
#include "core/calibration/quality/fault_search_input.h"
#include "core/calibration/wand/wand_calibration.h"

#include <vector>

namespace dewpoint::calibration {

/// Result of a search for faults.
struct FaultReport {
  std::vector<DetectedFault> faults;
  double sigmaPx =
      0.0; ///< standard deviation of an image point per axis, from the cameras that agree; pixels
};

/// Searches for the faults in CalibrationFault by solving again under each hypothesis.
///
/// Point positions are free, and no lengths are assumed, so that a wrong length cannot hide other
/// faults. Each camera in turn is left out. If the others agree, the left-out camera is explained
/// from their points by one of these hypotheses: unchanged, flipped, with another focal length,
/// with lens data for another resolution, with another pose from some time on, or shifted in time.
/// Pairs of cameras are also exchanged, and everything is solved again.
///
/// A hypothesis is reported if it gains more than 30 in log likelihood (Student's t, 4 degrees of
/// freedom) and 0.1 per measured number, and explains the images nearly as well as the cameras that
/// agree explain theirs. If several qualify, the best one is reported. If no camera is reported,
/// three more faults are tested: half-pixel shifts of all cameras, lengths relative to the size of
/// the initial rig, and the board's side and columns. With only two cameras, faults of a single
/// camera cannot be identified and are not searched for.
FaultReport findFaults(const FaultSearchInput& question);

/// Searches for faults in the observations of a wand. Errors: those of calibrateFromWand()
/// regarding its views.
Result<FaultReport> findWandFaults(const WandProblem& problem);

} // namespace dewpoint::calibration
