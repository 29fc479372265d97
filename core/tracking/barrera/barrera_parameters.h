// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/parameters.h"

#include <span>

namespace dewpoint::tracking {

/// Returns the parameters of the method of Barrera et al. 2005. The defaults are those of the paper
/// where it gives them.
std::span<const ParameterDeclaration> barreraParameters();

} // namespace dewpoint::tracking
