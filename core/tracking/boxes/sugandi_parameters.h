// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/parameters.h"

#include <span>

namespace dewpoint::tracking {

/// Returns the parameters of the method of Sugandi et al. 2009. The defaults are those of the paper
/// where it gives them (300 particles; its 8 x 8 x 8 bins are fixed).
std::span<const ParameterDeclaration> sugandiParameters();

} // namespace dewpoint::tracking
