// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/parameters.h"

#include <span>

namespace dewpoint::tracking {

/// Returns the declarations of the parameters of the `sugandi` method (Sugandi et al. 2009). The
/// defaults are taken from the paper if it gives them, such as 300 particles. The paper's 8 x 8 x 8
/// bins are fixed.
std::span<const ParameterDeclaration> sugandiParameters();

} // namespace dewpoint::tracking
