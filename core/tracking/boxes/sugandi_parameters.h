// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/parameters.h"

#include <span>

namespace dewpoint::tracking {

/// Parameters of the method of Sugandi et al. 2009; the defaults are the paper's where it states
/// them (300 particles; its other numbers, 8 x 8 x 8 bins, are fixed).
std::span<const ParameterDeclaration> sugandiParameters();

} // namespace dewpoint::tracking
