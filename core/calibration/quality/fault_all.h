// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/fault.h"
#include "core/calibration/quality/fault_question.h"

#include <optional>

namespace dewpoint::calibration {

/// Finds faults that all cameras share, from the joint fit of all: pixels off by one half.
std::optional<NamedFault> faultOfAll(const FaultQuestion& question, const ImagePoints& imagePoints,
                                     const PointFit& fit);

} // namespace dewpoint::calibration
