// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/parameters.h"

#include <span>

namespace dewpoint::tracking {

/// Returns the parameters of the `dynamics` method. The defaults are those of the paper (Barrera et
/// al. 2005, section III-C) where it gives them.
std::span<const ParameterDeclaration> dynamicsParameters();

} // namespace dewpoint::tracking
