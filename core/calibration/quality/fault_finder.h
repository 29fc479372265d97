// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/fault.h"
#include "core/calibration/quality/fault_question.h"
#include "core/calibration/wand/wand_calibration.h"

#include <vector>

namespace dewpoint::calibration {

struct FaultReport {
  std::vector<NamedFault> faults;
  double sigmaPx = 0.0; ///< of an image point per axis, as the cameras that agree show it
};

/// Looks for the faults of CalibrationFault by solving again with each hypothesis.
///
/// Points are taken by themselves (no lengths), so that a wrong length hides nothing. Each camera
/// in turn is left out; if the others agree, the left-out one is explained from their points: as it
/// is, flipped, with another focal length, with lens data of another resolution, with another pose
/// from some time on, shifted in time. Pairs are exchanged and all solved again. A hypothesis is
/// named when it gains more than 30 in log-likelihood (Student's, 4 degrees) and 0.1 per number
/// measured, and explains the images nearly as well as the cameras that agree explain theirs; of
/// several, the best. When no camera is named: half-pixel shifts of all, lengths against the
/// initial rig's size, and the board's side and columns. With two cameras, faults of a single one
/// cannot be told apart and are not searched for.
FaultReport findFaults(const FaultQuestion& question);

/// The same for a wand, as it was seen. Errors: those of calibrateFromWand() about its
/// views.
Result<FaultReport> findWandFaults(const WandProblem& problem);

} // namespace dewpoint::calibration
