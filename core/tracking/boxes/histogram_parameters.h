// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/parameters.h"

#include <span>

namespace dewpoint::tracking {

/// Returns the declarations of the parameters of the `histogram` method. Lengths are relative to
/// the target's size (the square root of the area of its box), so they suit targets of any size.
std::span<const ParameterDeclaration> histogramParameters();

} // namespace dewpoint::tracking
