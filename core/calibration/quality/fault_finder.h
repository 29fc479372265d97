// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/fault.h"
#include "core/calibration/quality/fault_search_input.h"
#include "core/calibration/wand/wand_calibration.h"

#include <vector>

namespace dewpoint::calibration {

/// Result of a search for faults: mistakes in a calibration, such as swapped cameras.
struct FaultReport {
  std::vector<DetectedFault> faults;
  /// Standard deviation of an image point per axis, from the cameras that agree; pixels.
  double sigmaPx = 0.0;
};

/// Searches for the faults listed in CalibrationFault. For each possible fault (hypothesis), the
/// poses are estimated again under the assumption that the fault is present.
///
/// Point positions are free, and no lengths are assumed, so that a wrong length cannot hide other
/// faults. Each camera in turn is left out. If the other cameras agree, their points show which
/// hypothesis best explains the images of the left-out camera: no fault, flipped images, another
/// focal length, lens data for another resolution, another pose from some time on, or a shift in
/// time. In addition, each pair of cameras is exchanged, and all poses are estimated again.
///
/// A hypothesis must increase the log likelihood (Student's t, 4 degrees of freedom) by more than
/// 30, and by more than 0.1 per measured coordinate. It must also explain the images of the suspect
/// camera nearly as well as the images of the cameras that agree are explained. If several
/// hypotheses fulfill this, the best one is reported. If no camera is reported, three more faults
/// are tested: half-pixel shifts of all cameras, lengths relative to the size of the initial rig,
/// and a board that is mirrored or has another number of columns. With only two cameras, faults of
/// a single camera cannot be identified and are not searched for.
FaultReport findFaults(const FaultSearchInput& input);

/// Searches for faults in the observations of a wand. Errors: those of checkViews(), which reports
/// missing or invalid views.
Result<FaultReport> findWandFaults(const WandProblem& problem);

} // namespace dewpoint::calibration
