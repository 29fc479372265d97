// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/fault.h"
#include "core/calibration/quality/fault_search_input.h"

#include <optional>

namespace dewpoint::calibration {

/// Finds faults common to all cameras, based on the joint fit of all: image points that are off by
/// half a pixel.
std::optional<DetectedFault> findCommonFault(const FaultSearchInput& question,
                                             const ImagePoints& imagePoints, const PointFit& fit);

} // namespace dewpoint::calibration
