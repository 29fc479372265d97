// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/parameters.h"

#include <span>

namespace dewpoint::tracking {

/// Returns the declarations of the parameters of the `dynamics` method (Barrera et al. 2005,
/// section III-C). The defaults are taken from the paper if it gives them.
std::span<const ParameterDeclaration> dynamicsParameters();

} // namespace dewpoint::tracking
