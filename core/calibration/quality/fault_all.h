// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/fault.h"
#include "core/calibration/quality/fault_search_input.h"

#include <optional>

namespace dewpoint::calibration {

/// Finds a fault that all cameras share: image points that are half a pixel off. Returns nothing if
/// there is no such fault. `fit` is the joint fit of all cameras.
std::optional<DetectedFault> findCommonFault(const FaultSearchInput& input,
                                             const ImagePoints& imagePoints, const PointFit& fit);

} // namespace dewpoint::calibration
