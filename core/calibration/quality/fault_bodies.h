// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/fault.h"
#include "core/calibration/quality/fault_search_input.h"

#include <vector>

namespace dewpoint::calibration {

/// Returns the faults found in the entered lengths, in the board and in the floor, such as a wrong
/// unit or a mirrored board. `positions`: positions of the points, triangulated by all cameras of
/// `rig`.
std::vector<DetectedFault> findBodyFaults(const FaultSearchInput& input,
                                          const PointPositions& positions, const CameraRig& rig);

/// Returns the relative standard deviation of the size of a rig whose poses have the standard
/// deviations `sigma`.
double sizeSigma(const CameraRig& rig, const InitialRigSigma& sigma);

} // namespace dewpoint::calibration
