// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/fault.h"
#include "core/calibration/quality/fault_search_input.h"

#include <vector>

namespace dewpoint::calibration {

/// Finds errors in the entered lengths, board and floor, using the point positions triangulated by
/// all cameras.
std::vector<DetectedFault> findBodyFaults(const FaultSearchInput& question,
                                          const PointPositions& positions, const CameraRig& rig);

/// Returns the relative standard deviation of the initial rig's size.
double sizeSigma(const CameraRig& rig, const InitialRigSigma& sigma);

} // namespace dewpoint::calibration
