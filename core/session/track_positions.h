// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/parameters.h"
#include "core/trajectory/trajectory.h"

#include <cstdint>

namespace dewpoint {

/// Method dynamics over measured 3D positions instead of images (Barrera et al. 2005, section
/// III-C): every target of `measured` is tracked by a filter of its own, which does the method's
/// iterations on each sample and starts at the target's first place. A sample whose position is not
/// a number, or that is not valid, is taken as not measured.
Trajectory trackPositions(const Trajectory& measured, const ParameterValues& parameters,
                          std::uint64_t seed);

} // namespace dewpoint
