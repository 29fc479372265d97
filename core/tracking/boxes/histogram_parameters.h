// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/parameters.h"

#include <span>

namespace dewpoint::tracking {

/// Parameters of method `histogram`. Lengths are shares of the target's size, the square root of
/// its box's area, so that they serve targets of any size.
std::span<const ParameterDeclaration> histogramParameters();

} // namespace dewpoint::tracking
