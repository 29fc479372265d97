// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/parameters.h"

#include <span>

namespace dewpoint::tracking {

/// Returns the declarations of the parameters of the `barrera` method (Barrera et al. 2005). The
/// defaults are taken from the paper if it gives them.
std::span<const ParameterDeclaration> barreraParameters();

} // namespace dewpoint::tracking
